// Bytes as a pattern and a format: what is written of it and read back is as strong as it was
// meant, or a remark says that it is not.
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "model/export/exported_set.h"
#include "model/pattern/drawn_fault.h"
#include "tests/fuzz/readers.h"
#include "tests/support/strength_off.h"

namespace tact::fuzz {
namespace {

// One byte for each number; zeros behind the last one.
class Numbers {
  public:
    explicit Numbers(std::string_view bytes) : rest_(bytes) {}

    std::size_t below(std::size_t count) {
        if (rest_.empty()) return 0;
        const auto byte = static_cast<std::uint8_t>(rest_.front());
        rest_.remove_prefix(1);
        return byte % count;
    }
    double within(double low, double high) {
        return low + (high - low) * static_cast<double>(below(256)) / 255.0;
    }

  private:
    std::string_view rest_;
};

Pattern pattern_of(Numbers& numbers) {
    Pattern pattern;
    pattern.duration_s = 0.001 * static_cast<double>(1 + 3 * numbers.below(256));
    pattern.amplitude_g = numbers.within(0.0, 4.0);
    pattern.carriers.front().frequency_hz = numbers.within(1.0, 500.0);
    if (numbers.below(4) == 3) pattern.carriers.push_back({numbers.within(20.0, 500.0), 0.7, 1.0});
    if (numbers.below(4) == 3) {
        pattern.modulation = {ModulationKind::am, numbers.within(0.5, 60.0), 1.0};
    }
    if (numbers.below(4) == 3) pattern.modulation.kind = ModulationKind::product;
    if (numbers.below(4) == 3) pattern.rhythm = {"x=-x", numbers.within(0.01, 0.1)};
    if (numbers.below(4) == 3) pattern.attack_s = numbers.within(0.0, 0.05);
    double t_s = 0.0;
    for (std::size_t k = numbers.below(8); k > 0; --k) {
        pattern.amplitude_curve.push_back({t_s, numbers.within(0.0, 1.0)});
        t_s = std::min(t_s + 0.001 * static_cast<double>(numbers.below(128)), pattern.duration_s);
    }
    for (std::size_t k = numbers.below(6); k > 0; --k) {
        Transient one;
        one.time_s = numbers.within(0.0, pattern.duration_s);
        one.amplitude_g = numbers.within(0.0, 3.0);
        one.frequency_hz = numbers.within(30.0, 400.0);
        one.duration_s = numbers.within(0.002, 0.06);
        pattern.transients.push_back(one);
    }
    return clamped(pattern);
}

bool says_nothing(const ExportedPattern& made) {
    return std::ranges::all_of(made.remarks, [](const std::string& remark) {
        return remark.starts_with("as it is read back: ");
    });
}

bool exports(std::string_view bytes) {
    Numbers numbers(bytes);
    const TargetTraits& format = target_formats()[numbers.below(target_formats().size())];
    const ExportTarget target = own_target(*target_format_of(format.key));
    const Pattern pattern = pattern_of(numbers);
    if (drawn_fault(pattern) || is_sampled(target.format)) return false;
    const ExportedPattern made = exported(pattern, "fuzz", target);
    for (const std::string& remark : made.remarks) {
        hold(!remark.starts_with("nothing of it comes back"),
             "its own reader takes what is written");
    }
    if (!says_nothing(made)) return true;
    const auto& back = std::get<Pattern>(made.back);
    hold(std::abs(back.duration_s - pattern.duration_s) <= 0.001 + 1e-9, "another length is said");
    const double off_db = strength_off::largest_db(pattern, back);
    hold(off_db <= 0.1 + strength_off::kOtherWayDb, "another strength is said");
    return true;
}

// One for each format; a curve, a rhythm, a modulation and a tap among them.
std::vector<std::string> exports_seeds() {
    std::vector<std::string> seeds;
    for (std::size_t f = 0; f < target_formats().size(); f += 4) {
        std::string seed(1, static_cast<char>(f));
        seed += "\x60\x40\x50";
        seed += std::string("\0\0\0\0\0", f % 8 == 0 ? 5 : 4);
        seed += "\x03\x80\x20\xff\x30\x40\x20\x01\x20\xa0\x60\x50";
        seeds.push_back(seed);
    }
    return seeds;
}

}  // namespace

std::span<const Reader> export_readers() {
    static const std::vector<Reader> all{{"exports", exports, exports_seeds, {}}};
    return all;
}

}  // namespace tact::fuzz
