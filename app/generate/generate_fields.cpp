#include "app/generate/parts.h"

#include <imgui.h>

#include <algorithm>

#include "app/patterns/patterns.h"
#include "app/ui/widgets.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

constexpr const char* kSteady = "steady";  // one note throughout, among rhythms

bool is_digit(char sign) { return sign >= '0' && sign <= '9'; }

// "0,5": a number with a comma for its point, or two numbers; empty: no such number. A comma
// separates numbers if a blank follows, or if a point shows that commas are not points: "0.5,1". In
// whole numbers without either, "60,120", only a zero before it or a semicolon elsewhere tells.
std::string decimal_comma_in(const std::string& text) {
    const bool has_other = text.find(';') != std::string::npos;
    for (std::size_t at = text.find(','); at != std::string::npos; at = text.find(',', at + 1)) {
        if (at == 0 || at + 1 >= text.size() || !is_digit(text[at - 1]) ||
            !is_digit(text[at + 1])) {
            continue;
        }
        const std::size_t before = text.find_last_of(",; ", at - 1);
        const std::size_t begin = before == std::string::npos ? 0 : before + 1;
        const std::string word = text.substr(begin, text.find_first_of(",; ", at + 1) - begin);
        const std::string whole = text.substr(begin, at - begin);
        if (word.find('.') != std::string::npos) continue;
        if (has_other || whole == "0" || whole == "-0") return word;
    }
    return {};
}

std::string with_point(std::string number) {
    number[number.find(',')] = '.';
    return number;
}

// The levels in a text; a fault if it has no level, or one is out of range.
Expected<std::vector<double>> levels_in(const std::string& text, Range allowed, const Unit& unit) {
    if (const std::string comma = decimal_comma_in(text); !comma.empty()) {
        return Error{"\"" + comma + "\" is one number or two: write " + with_point(comma) +
                     ", or a blank after the comma"};
    }
    std::vector<double> levels;
    for (const std::string& word : words_in(text)) {
        const auto number = finite_number_in(word);
        if (!number) return Error{"\"" + word + "\" is no number"};
        if (!allowed.contains(*number / unit.times)) {
            return Error{significant_digits(allowed.low * unit.times, 6) + " to " +
                         significant_digits(allowed.high * unit.times, 6) + " " + unit.name};
        }
        levels.push_back(*number / unit.times);
    }
    if (levels.empty()) return Error{"at least one number"};
    if (levels.size() > limits::kMaxLevels) return Error{"too many levels"};
    return levels;
}

// "fixed", "3 levels"; a level that stands there more than once is said to.
std::string level_words(const std::vector<double>& levels, const Unit& unit) {
    if (levels.size() == 1) return "fixed";
    const std::string words = std::to_string(levels.size()) + " levels";
    for (const double level : levels) {
        const auto times = std::ranges::count(levels, level);
        if (times < 2) continue;
        return words + ", " + significant_digits(unit.times * level, 6) + " of them " +
               std::to_string(times) + " times";
    }
    return words;
}

void draw_levels(Ui& ui, GenerateState& generating, const std::string& id,
                 std::vector<double>& levels, Range allowed, const Unit& unit) {
    std::string shown;
    for (const double level : levels) {
        shown += (shown.empty() ? "" : ", ") + significant_digits(unit.times * level, 6);
    }
    const auto typed = draw_entry(ui, generating, id, shown, 300.0F * ui.theme.scale);
    draw_tooltip(ui, "One number is fixed; several, with commas between them, are levels.");
    if (*unit.name != '\0') beside(ui, unit.name);
    std::string fault;
    if (typed) {
        auto found = levels_in(*typed, allowed, unit);
        if (found) levels = *std::move(found);
        if (!found) fault = found.error().message;
    }
    draw_remark(ui, generating, id, typed.has_value(), level_words(levels, unit), fault);
}

// "any" stands for values that are not moved.
void draw_multiple(Ui& ui, GenerateState& generating, const std::string& id, double& multiple,
                   const Unit& unit) {
    constexpr const char* kAny = "any";
    const std::string shown = multiple == 0.0 ? kAny : significant_digits(unit.times * multiple, 6);
    const auto typed = draw_entry(ui, generating, id, shown, 62.0F * ui.theme.scale);
    draw_tooltip(ui,
                 "Values are moved to the nearest multiple of this. Multiples of 1 / duration "
                 "do not leak.");
    std::string fault;
    if (!typed) return draw_remark(ui, generating, id, false, {}, fault);
    if (*typed == kAny) multiple = 0.0;
    if (*typed == kAny) return draw_remark(ui, generating, id, true, {}, fault);
    const Range allowed{unit.times * limits::kMultiple.low, unit.times * limits::kMultiple.high};
    const auto number = typed_number(*typed, unit.times * multiple, {allowed, unit.name});
    const bool good = number && number->remark.empty();
    if (good) multiple = number->value / unit.times;
    if (!good) fault = number ? number->remark : number.error().message;
    draw_remark(ui, generating, id, true, {}, fault);
}

void draw_span(Ui& ui, GenerateState& generating, const std::string& id, Span& span, Range allowed,
               const Unit& unit) {
    draw_number(ui, id + " from", span.from, allowed, unit);
    beside(ui, "to");
    ImGui::SameLine(0.0F, ui.theme.gap_px);
    draw_number(ui, id + " to", span.to, allowed, unit);
    if (*unit.name != '\0') beside(ui, unit.name);
    if (generating.draft.design == Design::factorial) {
        beside(ui, "in");
        ImGui::SameLine(0.0F, ui.theme.gap_px);
        draw_whole(ui, id + " steps", span.steps, limits::kSpanSteps);
        beside(ui, "steps");
    }
    ImGui::SameLine(0.0F, ui.theme.gap_px);
    if (option_chip(
            ui, id + " ratio", "equal ratios", span.logarithmic,
            "Spaced by equal ratios, as frequencies and strengths are felt, instead of equal "
            "differences. The range must begin above 0.")) {
        span.logarithmic = !span.logarithmic;
    }
    leave_gap(ui);
    ImGui::AlignTextToFramePadding();
    dim_text(ui, "multiples of");
    ImGui::SameLine(0.0F, ui.theme.gap_px);
    draw_multiple(ui, generating, id + " multiple", span.multiple_of, unit);
}

// A range around what the levels were.
Span span_from(const std::vector<double>& levels, Parameter parameter) {
    const auto [low, high] = std::ranges::minmax(levels);
    const Range allowed = range_of(parameter);
    Span span{low, high, 3, false, 0.0};
    if (low == high) span.from = std::max(low / 2.0, allowed.low);
    if (low == high) span.to = std::min(low == 0.0 ? 1.0 : 2.0 * low, allowed.high);
    if (span.from > span.to) std::swap(span.from, span.to);
    span.logarithmic = parameter == Parameter::frequency && span.from > 0.0;
    if (parameter == Parameter::frequency) span.multiple_of = 1.0;
    return span;
}

void draw_values(Ui& ui, GenerateState& generating, Factor factor) {
    const std::string id = lower_case(name_of(factor));
    const Range allowed = range_of(factor.parameter);
    const Unit unit = unit_of(factor.parameter);
    Values& values = *values_of(generating.draft, factor);
    auto* levels = std::get_if<std::vector<double>>(&values);
    if (option_chip(ui, id + " values", "Values", levels != nullptr,
                    "One number, or several levels") &&
        levels == nullptr) {
        const Span span = std::get<Span>(values);
        values = std::vector<double>{span.from, span.to};
    } else if (option_chip(ui, id + " range", "Range", levels == nullptr,
                           "Anything from one number to another") &&
               levels != nullptr) {
        values = span_from(*levels, factor.parameter);
    }
    leave_gap(ui);
    if (auto* now = std::get_if<std::vector<double>>(&values)) {
        draw_levels(ui, generating, id, *now, allowed, unit);
    } else {
        draw_span(ui, generating, id, std::get<Span>(values), allowed, unit);
    }
}

void draw_kinds(Ui& ui, GenerateState& generating) {
    auto& kinds = generating.draft.kinds;
    const auto toggle = [&](const char* text, ModulationKind kind, const char* help) {
        const bool lit = std::ranges::find(kinds, kind) != kinds.end();
        if (!option_chip(ui, text, text, lit, help)) return;
        if (!lit) kinds.push_back(kind);
        if (lit && kinds.size() > 1) std::erase(kinds, kind);
        std::ranges::sort(kinds);
    };
    toggle("Ring", ModulationKind::product, "Times sin(2 pi f t): Eq. 7 of the paper");
    toggle("Tremolo", ModulationKind::am, "Times 1 + m sin(2 pi f t): the kind with a depth m");
    leave_gap(ui);
    ImGui::AlignTextToFramePadding();
    dim_text(ui, kinds.size() == 1 ? "fixed" : "2 levels");
}

// Membership of a rhythm in the list, which is never empty.
void toggle_rhythm(std::vector<std::string>& rhythms, const std::string& text) {
    if (std::erase(rhythms, text) == 0) rhythms.push_back(text);
    if (rhythms.empty()) rhythms.emplace_back();
}

void draw_rhythm_popup(Ui& ui, GenerateState& generating) {
    const float width = 360.0F * ui.theme.scale;
    ImGui::SetNextWindowSizeConstraints({width, 0.0F}, {width, 1e4F});
    if (!ImGui::BeginPopup("rhythms")) return;
    auto& rhythms = generating.draft.rhythms;
    const auto has = [&rhythms](const std::string& text) {
        return std::ranges::find(rhythms, text) != rhythms.end();
    };
    Pattern shown;
    for (const Factor factor : {Factor{Parameter::unit}, Factor{Parameter::duration},
                                Factor{Parameter::attack}, Factor{Parameter::release}}) {
        set_value(shown, generating.draft, factor, 0.0);
    }
    const RhythmListAction action =
        draw_rhythm_list(ui, generating.rhythms, shown, has, "Add all of them");
    if (action.pressed) toggle_rhythm(rhythms, *action.pressed);
    if (action.all) {
        for (const std::string& text : generating.rhythms.texts) {
            if (!has(text) && rhythms.size() < limits::kMaxLevels) rhythms.push_back(text);
        }
    }
    ImGui::EndPopup();
}

void draw_rhythms(Ui& ui, GenerateState& generating) {
    auto& rhythms = generating.draft.rhythms;
    std::string shown;
    for (const std::string& text : rhythms) {
        shown += (shown.empty() ? "" : " ") + (text.empty() ? std::string(kSteady) : text);
    }
    const auto typed = draw_entry(ui, generating, "rhythm", shown, 420.0F * ui.theme.scale);
    draw_tooltip(ui,
                 "Rhythms with blanks between them: x note, 1 to 9 a weaker one, = hold, - rest. "
                 "\"steady\" is one "
                 "note throughout.");
    std::string fault;
    if (typed) {
        std::vector<std::string> found;
        for (const std::string& word : words_in(*typed)) {
            found.push_back(word == kSteady ? "" : word);
            if (fault.empty()) fault = rhythm_fault(found.back());
        }
        if (found.empty()) fault = "at least one rhythm";
        if (fault.empty()) rhythms = std::move(found);
    }
    const std::size_t count = rhythms.size();
    draw_remark(ui, generating, "rhythm", typed.has_value(),
                count == 1 ? "fixed" : std::to_string(count) + " levels", fault);
    ImGui::SameLine(0.0F, 2.0F * ui.theme.gap_px);
    if (option_link(ui, "choose rhythms", "Choose...")) ImGui::OpenPopup("rhythms");
    ImGui::NewLine();
    draw_rhythm_popup(ui, generating);
}

// False where the parameter changes nothing, whatever its value.
bool matters(const DesignSpace& space, Parameter parameter) {
    const bool one_carrier = space.carriers.size() == 1;
    if (parameter == Parameter::weight) return !one_carrier;
    if (parameter == Parameter::depth) {
        return std::ranges::find(space.kinds, ModulationKind::am) != space.kinds.end();
    }
    const auto is_steady = [](const std::string& text) { return text.empty(); };
    return parameter != Parameter::unit || !std::ranges::all_of(space.rhythms, is_steady);
}

void draw_carrier_links(Ui& ui, GenerateState& generating) {
    DesignSpace& space = generating.draft;
    const float below = ImGui::GetCursorPosY() + ImGui::GetFrameHeightWithSpacing();
    draw_label(ui, "");
    const std::size_t before = space.carriers.size();
    if (before < limits::kMaxCarriers && option_link(ui, "add carrier", "Add carrier")) {
        space.carriers.emplace_back();
    }
    if (before > 1 && option_link(ui, "remove carrier", "Remove")) space.carriers.pop_back();
    ImGui::NewLine();
    ImGui::SetCursorPosY(below);  // as high as any row
    if (space.carriers.size() == before) return;
    space.mix.reset();
    if (space.carriers.size() == 2) space.mix = fixed(0.5);
}

// A constraint with one number.
struct LimitRow {
    const char* label;
    const char* id;
    double first;  // when it is put on
    Range allowed;
    Unit unit;
    const char* before;  // the number
    const char* words;   // behind it
    const char* help;
};

// While it is off, its words also say what a tick would ask for.
bool limit_box(Ui& ui, const char* id, const char* words, const std::string& would_be, bool on,
               const char* help) {
    bool ticked = on;
    return check(ui,
                 {.id = std::string("generate:") + id,
                  .label = std::string(words) + (on ? "" : " " + would_be),
                  .tip = help,
                  .value = on ? "chosen" : ""},
                 ticked);
}

void draw_limit(Ui& ui, std::optional<double>& limit, const LimitRow& row) {
    draw_label(ui, row.label);
    if (limit) reset_by_label(ui, row.first, *limit);
    const std::string would_be = significant_digits(row.first, 6) + " " + row.words;
    if (limit_box(ui, row.id, row.before, would_be, limit.has_value(), row.help)) {
        limit = limit ? std::nullopt : std::optional(row.first);
    }
    if (!limit) return;
    ImGui::SameLine(0.0F, ui.theme.gap_px);
    draw_number(ui, std::string(row.id) + " limit", *limit, row.allowed, row.unit);
    beside(ui, row.words);
}

}  // namespace

void draw_factor_rows(Ui& ui, GenerateState& generating) {
    for (const Factor factor : factors(generating.draft)) {
        const DesignSpace& space = generating.draft;
        if (!matters(space, factor.parameter)) continue;
        const std::string name = name_of(factor);
        if (factor.parameter == Parameter::kind) draw_carrier_links(ui, generating);
        draw_label(ui, name.c_str());
        ImGui::PushID(name.c_str());
        if (factor.parameter == Parameter::kind) {
            draw_kinds(ui, generating);
        } else if (factor.parameter == Parameter::rhythm) {
            draw_rhythms(ui, generating);
        } else {
            draw_values(ui, generating, factor);
        }
        ImGui::PopID();
    }
}

void draw_design_row(Ui& ui, GenerateState& generating) {
    DesignSpace& space = generating.draft;
    draw_label(ui, "Design");
    const auto choose = [&](const char* text, Design design, const char* help) {
        if (option_chip(ui, text, text, space.design == design, help)) space.design = design;
    };
    choose("Full factorial", Design::factorial,
           "Every combination of all levels; ranges are cut in steps.");
    choose("Latin hypercube", Design::latin_hypercube,
           "Each range is cut in as many parts as there are samples, and each part is used once.");
    choose("Sobol", Design::sobol,
           "Samples spread evenly over all parameters together by Sobol's sequence.");
    if (space.design == Design::factorial) return ImGui::NewLine();
    leave_gap(ui);
    draw_whole(ui, "samples", space.samples, limits::kSamples);
    beside(ui, "samples");
    reset_by_label(ui, DesignSpace{}.samples, space.samples);
    ImGui::SameLine(0.0F, 2.0F * ui.theme.gap_px);
    dim_text(ui, "seed");
    reset_by_label(ui, DesignSpace{}.seed, space.seed);
    ImGui::SameLine(0.0F, ui.theme.gap_px);
    draw_whole(ui, "seed", space.seed, limits::kSeed);
    draw_tooltip(ui,
                 "The same seed makes the same sample again; with 0, Sobol's sequence is the "
                 "published one.");
}

void draw_constraint_rows(Ui& ui, GenerateState& generating) {
    Constraints& limits_of = generating.draft.constraints;
    constexpr Range kNormalHz{40.0, 400.0};
    draw_label(ui, "Device band");
    if (limits_of.band_hz && is_reset_asked(ui)) limits_of.band_hz = kNormalHz;
    const std::string would_be = significant_digits(kNormalHz.low, 6) + " to " +
                                 significant_digits(kNormalHz.high, 6) + " Hz";
    if (limit_box(ui, "band", "within", would_be, limits_of.band_hz.has_value(),
                  "Carriers and the sidebands of their modulation must lie in it.")) {
        limits_of.band_hz = limits_of.band_hz ? std::nullopt : std::optional(kNormalHz);
    }
    if (limits_of.band_hz) {
        ImGui::SameLine(0.0F, ui.theme.gap_px);
        draw_number(ui, "band low", limits_of.band_hz->low, limits::kBandHz, {"Hz", 1.0});
        beside(ui, "to");
        ImGui::SameLine(0.0F, ui.theme.gap_px);
        draw_number(ui, "band high", limits_of.band_hz->high, limits::kBandHz, {"Hz", 1.0});
        beside(ui, "Hz");
    }
    draw_limit(ui, limits_of.displacement_um,
               {"Displacement",
                "displacement",
                100.0,
                limits::kDisplacementUm,
                {"\u00b5m", 1.0},
                "at most",
                "\u00b5m",
                "Peak displacement if all components meet at their peaks: what the actuator's "
                "stroke must hold."});
    draw_limit(ui, limits_of.detectable_db,
               {"Detectable",
                "detectable",
                6.0,
                limits::kDetectableDb,
                {"dB", 1.0},
                "at least",
                "dB above threshold",
                "At least one component is so far above the threshold of a receptor type, by the "
                "model's tables."});
}

}  // namespace tact
