#include "devices/hid/haptic_page.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace tact {

namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::uint32_t kHapticsPage = 0x0E;
constexpr std::uint32_t kOrdinalPage = 0x0A;

std::uint32_t usage(std::uint32_t page, std::uint32_t id) { return (page << 16) | id; }

// What holds for the fields that follow, until changed.
struct Globals {
    std::uint32_t page = 0;
    std::int32_t least = 0;
    std::int32_t most = 0;
    std::uint32_t bits = 0;
    std::uint32_t count = 0;
    std::uint8_t report = 0;
};

enum class ReportKind { input, output, feature };

struct Item {
    int kind = 0;  // 0 main, 1 global, 2 local
    int tag = 0;
    std::size_t bytes = 0;
    std::uint32_t value = 0;
    std::int32_t signed_value = 0;
};

// The next short item; nothing at the end or in the middle of one. Long items are passed over.
std::optional<Item> next_item(Bytes& rest) {
    while (rest.size() >= 3 && rest[0] == 0xFE) {
        const std::size_t length = 3U + rest[1];
        if (length > rest.size()) return std::nullopt;
        rest = rest.subspan(length);
    }
    if (rest.empty()) return std::nullopt;
    const int head = rest[0];
    Item item;
    item.bytes = (head & 3) == 3 ? 4 : static_cast<std::size_t>(head & 3);
    item.kind = (head >> 2) & 3;
    item.tag = head >> 4;
    if (rest.size() < 1 + item.bytes) return std::nullopt;
    for (std::size_t k = 0; k < item.bytes; ++k) {
        item.value |= static_cast<std::uint32_t>(rest[1 + k]) << (8 * k);
    }
    item.signed_value = static_cast<std::int32_t>(item.value);
    if (item.bytes == 1) item.signed_value = static_cast<std::int8_t>(item.value);
    if (item.bytes == 2) item.signed_value = static_cast<std::int16_t>(item.value);
    rest = rest.subspan(1 + item.bytes);
    return item;
}

// A reading of a whole descriptor.
class Reading {
  public:
    HapticPage page;
    bool broken = false;

    void take(const Item& item) {
        if (broken) return;
        if (item.kind == 0) take_main(item);
        if (item.kind == 1) take_global(item);
        if (item.kind == 2) take_local(item);
    }

    // Lengths are known when all fields are.
    void finish() {
        page.output_bytes = bytes_of(ReportKind::output, page.output_report);
        page.waveform_bytes = bytes_of(ReportKind::feature, page.waveform_report);
    }

  private:
    static constexpr std::uint32_t kMostBits = 8 * 4096;  // as the kernel allows
    static constexpr std::size_t kMostUsages = 1024;      // of an item, and waveforms of a list

    Globals globals_;
    std::vector<Globals> pushed_;
    std::vector<std::uint32_t> usages_;
    std::optional<std::uint32_t> first_usage_;
    std::vector<std::uint32_t> collections_;
    std::map<std::pair<ReportKind, int>, std::size_t> bits_;

    std::size_t bytes_of(ReportKind kind, int report) const {
        const auto found = bits_.find({kind, report});
        return found == bits_.end() ? 0 : (found->second + 7) / 8;
    }

    bool is_inside(std::uint32_t collection) const {
        return std::ranges::find(collections_, collection) != collections_.end();
    }

    void take_main(const Item& item) {
        switch (item.tag) {
            case 8:
                take_fields(ReportKind::input, item);
                break;
            case 9:
                take_fields(ReportKind::output, item);
                break;
            case 11:
                take_fields(ReportKind::feature, item);
                break;
            case 10:
                collections_.push_back(usages_.empty() ? 0 : usages_.front());
                break;
            case 12:
                if (collections_.empty())
                    broken = true;
                else
                    collections_.pop_back();
                break;
            default:
                break;
        }
        usages_.clear();
        first_usage_.reset();
    }

    void take_global(const Item& item) {
        switch (item.tag) {
            case 0:
                globals_.page = item.value;
                break;
            case 1:
                globals_.least = item.signed_value;
                break;
            case 2:  // some descriptors write 255 in a byte and mean it
                globals_.most = globals_.least >= 0 && item.signed_value < 0
                                    ? static_cast<std::int32_t>(item.value & 0x7FFFFFFF)
                                    : item.signed_value;
                break;
            case 7:
                globals_.bits = item.value;
                break;
            case 8:
                globals_.report = static_cast<std::uint8_t>(item.value);
                break;
            case 9:
                globals_.count = item.value;
                break;
            case 10:
                pushed_.push_back(globals_);
                break;
            case 11:
                if (pushed_.empty()) return void(broken = true);
                globals_ = pushed_.back();
                pushed_.pop_back();
                break;
            default:
                break;
        }
    }

    void take_local(const Item& item) {
        const std::uint32_t whole = item.bytes == 4 ? item.value : usage(globals_.page, item.value);
        if (item.tag == 0 && usages_.size() < kMostUsages) usages_.push_back(whole);
        if (item.tag == 1) first_usage_ = whole;
        if (item.tag != 2 || !first_usage_) return;
        for (std::uint32_t k = *first_usage_; k <= whole && usages_.size() < kMostUsages; ++k) {
            usages_.push_back(k);
        }
    }

    void take_fields(ReportKind kind, const Item& item) {
        if (globals_.count > kMostBits || globals_.bits > kMostBits) return void(broken = true);
        if (globals_.bits == 0) return;  // as many as one likes would fit
        std::size_t& bit = bits_[{kind, globals_.report}];
        constexpr std::uint32_t kConstant = 1;
        constexpr std::uint32_t kVariable = 2;
        const bool is_field = (item.value & kConstant) == 0 && (item.value & kVariable) != 0;
        for (std::uint32_t k = 0; k < globals_.count && !broken; ++k, bit += globals_.bits) {
            broken = bit > kMostBits;
            if (!is_field || usages_.empty() || globals_.bits > 32) continue;
            const std::uint32_t its = usages_[std::min<std::size_t>(k, usages_.size() - 1)];
            note(kind, its, {bit, globals_.bits, globals_.least, globals_.most});
        }
        if (bit > kMostBits) broken = true;
    }

    void note(ReportKind kind, std::uint32_t its, const ReportField& field) {
        if (kind == ReportKind::feature && is_inside(usage(kHapticsPage, 0x10)) &&
            (its >> 16) == kOrdinalPage) {
            page.waveform_report = globals_.report;
            if (page.waveforms.size() == kMostUsages) return void(broken = true);
            page.waveforms.push_back({static_cast<int>(its & 0xFFFF), field});
        }
        if (kind != ReportKind::output || (its >> 16) != kHapticsPage) return;
        ReportField* const known = output_field(its & 0xFFFF);
        if (known == nullptr || known->bits > 0) return;
        if (known == &page.trigger) page.output_report = globals_.report;
        // One report is written: that with the trigger.
        if (page.trigger.bits > 0 && globals_.report != page.output_report) return;
        *known = field;
    }

    ReportField* output_field(std::uint32_t id) {
        switch (id) {
            case 0x21:
                return &page.trigger;
            case 0x23:
                return &page.intensity;
            case 0x24:
                return &page.repeats;
            case 0x25:
                return &page.retrigger_period;
            case 0x28:
                return &page.cutoff_time;
            default:
                return nullptr;
        }
    }
};

std::uint32_t bits_in(Bytes bytes, const ReportField& field) {
    std::uint32_t value = 0;
    for (std::size_t k = 0; k < field.bits; ++k) {
        const std::size_t bit = field.bit + k;
        if (bit / 8 >= bytes.size()) break;
        const std::uint32_t one = (bytes[bit / 8] >> (bit % 8)) & 1U;
        value |= one << k;
    }
    return value;
}

void put(std::span<std::uint8_t> bytes, const ReportField& field, std::uint32_t value) {
    for (std::size_t k = 0; k < field.bits; ++k) {
        const std::size_t bit = field.bit + k;
        if (bit / 8 >= bytes.size()) return;
        const auto mask = static_cast<std::uint8_t>(1U << (bit % 8));
        if (((value >> k) & 1U) != 0) bytes[bit / 8] |= mask;
    }
}

}  // namespace

std::optional<HapticPage> haptic_page(Bytes descriptor) {
    Reading reading;
    while (const std::optional<Item> item = next_item(descriptor)) reading.take(*item);
    if (!descriptor.empty() || reading.broken || reading.page.trigger.bits == 0) return {};
    reading.finish();
    return reading.page;
}

std::optional<int> continuous_waveform(const HapticPage& page, Bytes waveform_report) {
    constexpr std::uint32_t kBuzz = 0x1004;
    constexpr std::uint32_t kRumble = 0x1005;
    if (waveform_report.empty()) return {};
    std::optional<int> buzz;
    for (const WaveformOrdinal& waveform : page.waveforms) {
        const std::uint32_t what = bits_in(waveform_report.subspan(1), waveform.field);
        if (what == kRumble) return waveform.ordinal;
        if (what == kBuzz) buzz = waveform.ordinal;
    }
    return buzz;
}

Packet haptic_output(const HapticPage& page, int ordinal, double share) {
    Packet packet(1 + page.output_bytes, 0);
    packet[0] = page.output_report;
    const std::span<std::uint8_t> bytes = std::span(packet).subspan(1);
    put(bytes, page.trigger, static_cast<std::uint32_t>(ordinal));
    const ReportField& intensity = page.intensity;
    const double reach = static_cast<double>(intensity.most) - intensity.least;
    const double value = intensity.least + std::clamp(share, 0.0, 1.0) * reach;
    put(bytes, intensity, static_cast<std::uint32_t>(std::lround(value)));
    return packet;
}

}  // namespace tact
