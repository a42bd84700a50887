#include "model/io/set/waveform_folder.h"

#include <algorithm>
#include <initializer_list>
#include <limits>
#include <map>
#include <string_view>
#include <utility>

#include "model/text/natural_order.h"
#include "model/text/numbers.h"
#include "model/text/unique_names.h"
#include "model/text/utf8.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

struct Listing {
    std::vector<fs::path> files;  // in natural order of their stems
    std::size_t others = 0;       // neither recordings, nor their sidecars, nor hidden
};

bool is_sidecar(const fs::path& path) {
    return extension_of(path) == ".json" && extension_of(path.stem()) == ".wav";
}

Expected<Listing> listed(const fs::path& folder, std::initializer_list<std::string_view> kinds) {
    Listing listing;
    std::error_code fault;
    for (fs::directory_iterator entry(folder, fault), end; !fault && entry != end;
         entry.increment(fault)) {
        const fs::path& path = entry->path();
        std::error_code none;
        if (path.filename().string().starts_with('.')) continue;
        if (!entry->is_directory(none) && std::ranges::count(kinds, extension_of(path)) > 0) {
            listing.files.push_back(path);
        } else if (!is_sidecar(path)) {
            ++listing.others;
        }
    }
    if (fault) return Error{folder.string() + ": cannot be read: " + fault.message()};
    std::ranges::sort(listing.files, [](const fs::path& a, const fs::path& b) {
        const std::string stem_a = a.stem().string();
        const std::string stem_b = b.stem().string();
        return stem_a == stem_b ? a < b : naturally_before(stem_a, stem_b);
    });
    return listing;
}

std::string kinds_text(std::initializer_list<std::string_view> kinds) {
    std::string text;
    for (const std::string_view kind : kinds)
        text += (text.empty() ? "" : " or ") + std::string(kind);
    return text;
}

// A remark on waveforms of several lengths, or empty.
std::string lengths_remark(const PatternSet& set) {
    std::size_t shortest = std::numeric_limits<std::size_t>::max();
    std::size_t longest = 0;
    for (const Vibration& vibration : set.vibrations) {
        const auto& waveform = *std::get<Measurement>(vibration.source).waveform;
        shortest = std::min(shortest, waveform.samples_g.size());
        longest = std::max(longest, waveform.samples_g.size());
    }
    if (shortest >= longest) return {};
    return "lengths of " + grouped_digits(shortest) + " to " + grouped_digits(longest) +
           " samples, the shorter ones are padded with zeros";
}

Expected<Loaded> read_folder(const fs::path& folder,
                             std::initializer_list<std::string_view> kinds) {
    const std::string name = folder.string();
    const auto listing = listed(folder, kinds);
    if (!listing) return listing.error();
    if (listing->files.empty()) {
        return Error{name + ": expected at least one " + kinds_text(kinds) +
                     " file in this folder, got none"};
    }
    if (listing->files.size() > limits::kMaxPatterns) {
        return Error{name + ": expected at most " + grouped_digits(limits::kMaxPatterns) +
                     " files, got " + grouped_digits(listing->files.size())};
    }
    Loaded loaded;
    std::error_code none;
    loaded.set.name = valid_utf8(fs::weakly_canonical(folder, none).filename().string());
    std::vector<std::string> names;
    std::vector<FileRemark> remarks;
    std::size_t samples = 0;
    for (const fs::path& file : listing->files) {
        auto vibration = vibration_from(file, remarks);
        if (!vibration) return vibration.error();
        samples += recorded_samples(*vibration);
        if (const auto fault = samples_fault(samples); !fault.empty()) {
            return Error{file.string() + ": " + fault};
        }
        names.push_back(vibration->name);
        loaded.set.vibrations.push_back(*std::move(vibration));
    }
    if (const auto equal = first_equal(names)) {
        return Error{name + ": " + listing->files[equal->first].filename().string() + " and " +
                     listing->files[equal->second].filename().string() + " both give the name " +
                     in_quotes(names[equal->second]) + ", expected names that differ"};
    }
    loaded.remarks = joined(remarks);
    if (const auto remark = lengths_remark(loaded.set); !remark.empty()) {
        loaded.remarks.push_back(name + ": " + remark);
    }
    if (listing->others > 0) {
        loaded.remarks.push_back(name + ": " + grouped_digits(listing->others) +
                                 (listing->others == 1 ? " other file" : " other files") +
                                 " ignored");
    }
    return loaded;
}

}  // namespace

Expected<Loaded> read_waveform_folder(const fs::path& folder) {
    return read_folder(folder, {".txt", ".wav"});
}

Expected<Loaded> read_text_folder(const fs::path& folder) { return read_folder(folder, {".txt"}); }

Expected<Vibration> vibration_from(const fs::path& path, std::vector<FileRemark>& remarks) {
    auto recording = read_recording(path);
    if (!recording) return recording.error();
    for (const std::string& remark : recording->remarks) {
        remarks.push_back({path.string(), remark});
    }
    Vibration vibration;
    vibration.name = valid_utf8(path.stem().string());
    std::error_code none;
    Measurement measurement;
    measurement.path =
        (fs::weakly_canonical(fs::absolute(path, none).parent_path(), none) / path.filename())
            .string();
    measurement.scale_g = recording->scale_g;
    measurement.waveform = std::make_shared<const Waveform>(std::move(recording->waveform));
    vibration.source = std::move(measurement);
    return vibration;
}

std::vector<std::string> joined(const std::vector<FileRemark>& remarks) {
    std::map<std::string, std::size_t> count;
    for (const FileRemark& remark : remarks) ++count[remark.text];
    std::vector<std::string> result;
    for (const FileRemark& remark : remarks) {
        const std::size_t files = std::exchange(count[remark.text], 0);
        if (files == 0) continue;
        const std::string others = files == 1 ? "" : " and " + grouped_digits(files - 1) + " more";
        result.push_back(remark.file + others + ": " + remark.text);
    }
    return result;
}

}  // namespace tact
