// Android's vibrations as XML: <vibration-effect>, or several in a <vibration-select>.
//
// Source    the platform's own parser and its tests (API 36, Apache-2.0). An envelope of waveforms:
//           amplitude and Hz straight between points, from amplitude 0 and the first point's Hz. A
//           basic envelope: sharpness straight from the lowest to the highest Hz, intensity a share
//           of the greatest level (dB) above threshold, 0 at its end.
// Guessed   that greatest level, which is the device's (ActuatorMap::sensation_db), at any Hz; the
//           Hz of waveform-effects; the device's own amplitude: the greatest.
// Assumed   courses of predefined effects and primitives (android_courses.h).
//           Primitives follow each other: delayMs is a pause behind the one before, or with
//           delayType="relative_start_offset" the time since that one began; one that would
//           overlap is left out, as the platform does.
// Refused   what the platform's parser refuses; effects of vendors: their courses are the device's.
// Left out  repetition: once; of a <vibration-select>, effects of vendors.

#include <algorithm>
#include <array>
#include <initializer_list>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>

#include "model/common/portable.h"
#include "model/io/formats/android/android.h"
#include "model/io/formats/android/android_courses.h"
#include "model/text/names.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

constexpr double kUnknownHz = 165.0;
constexpr Range kXmlHz{0.001, 1e6};

struct XmlReading {
    const EffectFile& file;
    std::string fault;
    std::vector<std::string> remarks;
    Voice voice;                  // of the effect being read, so far
    Sketch primitives;            // ... or what it is composed of
    bool is_the_devices = false;  // the fault is no fault of the file's
};

void refuse_node(XmlReading& xml, const pugi::xml_node& node, const std::string& sentence) {
    if (!xml.fault.empty()) return;
    xml.fault = xml.file.path + ": " + node.path() + ": " + sentence;
}

double attribute_number(XmlReading& xml, const pugi::xml_node& node, const char* name,
                        Range range) {
    const pugi::xml_attribute attribute = node.attribute(name);
    const auto number = finite_number_in(attribute.value());
    if (attribute && number && range.contains(*number)) return *number;
    refuse_node(xml, node,
                std::string(name) + ": expected a number from " + shortest_digits(range.low) +
                    " to " + shortest_digits(range.high) +
                    (attribute ? ", got " + in_quotes(attribute.value()) : ", it is missing"));
    return range.low;
}

double length_s_of(XmlReading& xml, const pugi::xml_node& node, double least_ms) {
    return attribute_number(xml, node, "durationMs", {least_ms, kEffectTimeMs.high}) / 1e3;
}

// A point from the present end on; two at one time where it does not begin as the last one ended.
void line_to(Voice& voice, double time_s, double from_g, double from_hz, double to_g,
             double to_hz) {
    voice.amplitude.push_back({voice.end_s, from_g});
    voice.frequency.push_back({voice.end_s, from_hz});
    voice.amplitude.push_back({time_s, to_g});
    voice.frequency.push_back({time_s, to_hz});
    voice.end_s = time_s;
}

// The platform's parser refuses what it does not know.
void check_attributes(XmlReading& xml, const pugi::xml_node& node,
                      std::initializer_list<std::string_view> known) {
    for (const pugi::xml_attribute& attribute : node.attributes()) {
        if (std::ranges::find(known, attribute.name()) != known.end()) continue;
        refuse_node(xml, node, "expected no attribute " + in_quotes(attribute.name()));
    }
}

bool has_only(XmlReading& xml, const pugi::xml_node& node, const char* child_name) {
    for (const pugi::xml_node& child : node.children()) {
        if (child.type() == pugi::node_element && child_name == std::string(child.name())) continue;
        refuse_node(
            xml, node,
            std::string("expected <") + child_name + "> alone, got " +
                in_quotes(child.type() == pugi::node_element ? child.name() : child.value()));
        return false;
    }
    if (node.first_child()) return true;
    refuse_node(xml, node, std::string("expected at least one <") + child_name + ">, got none");
    return false;
}

void read_waveform_envelope(XmlReading& xml, const pugi::xml_node& node) {
    check_attributes(xml, node, {"initialFrequencyHz"});
    if (!has_only(xml, node, "control-point")) return;
    const bool initial = !node.attribute("initialFrequencyHz").empty();
    double hz = initial ? attribute_number(xml, node, "initialFrequencyHz", kXmlHz)
                        : attribute_number(xml, node.first_child(), "frequencyHz", kXmlHz);
    double amplitude_g = 0.0;
    const ActuatorMap& map = xml.file.map;
    for (const pugi::xml_node& point : node.children()) {
        check_attributes(xml, point, {"amplitude", "frequencyHz", "durationMs"});
        const double share = attribute_number(xml, point, "amplitude", kShare);
        const double to_hz = attribute_number(xml, point, "frequencyHz", kXmlHz);
        const double to_g = map.full_scale_g * map.continuous_gain * share;
        const double end_s = xml.voice.end_s + length_s_of(xml, point, 1.0);
        line_to(xml.voice, end_s, amplitude_g, hz, to_g, to_hz);
        amplitude_g = to_g;
        hz = to_hz;
    }
}

double felt_g(const ActuatorMap& map, double intensity) {
    if (!(intensity > 0.0)) return 0.0;
    const double below_full_db = (intensity - 1.0) * map.sensation_db;
    return map.full_scale_g * map.continuous_gain * portable::pow(10.0, below_full_db / 20.0);
}

void read_basic_envelope(XmlReading& xml, const pugi::xml_node& node) {
    check_attributes(xml, node, {"initialSharpness"});
    if (!has_only(xml, node, "control-point")) return;
    const ActuatorMap& map = xml.file.map;
    const bool initial = !node.attribute("initialSharpness").empty();
    const double sharpness = initial
                                 ? attribute_number(xml, node, "initialSharpness", kShare)
                                 : attribute_number(xml, node.first_child(), "sharpness", kShare);
    AmplitudeCurve intensities{{xml.voice.end_s, 0.0}};
    AmplitudeCurve sharpnesses{{xml.voice.end_s, sharpness}};
    for (const pugi::xml_node& point : node.children()) {
        check_attributes(xml, point, {"intensity", "sharpness", "durationMs"});
        xml.voice.end_s += length_s_of(xml, point, 1.0);
        intensities.push_back({xml.voice.end_s, attribute_number(xml, point, "intensity", kShare)});
        sharpnesses.push_back({xml.voice.end_s, attribute_number(xml, point, "sharpness", kShare)});
    }
    if (intensities.back().value != 0.0) {
        refuse_node(xml, node.last_child(), "intensity: expected 0 at the end of a basic envelope");
    }
    const auto to_g = [&map](double intensity) { return felt_g(map, intensity); };
    const auto accelerations = mapped(intensities, to_g, 1e-3 * felt_g(map, 1.0));
    const FrequencyCurve hz = frequency_curve(map, sharpnesses);
    xml.voice.amplitude.insert(xml.voice.amplitude.end(), accelerations.begin(),
                               accelerations.end());
    xml.voice.frequency.insert(xml.voice.frequency.end(), hz.begin(), hz.end());
    remark_once(xml.remarks, shortest_digits(map.sensation_db) +
                                 " dB above threshold are guessed as the device's greatest level");
}

void read_entry(XmlReading& xml, const pugi::xml_node& entry) {
    check_attributes(xml, entry, {"durationMs", "amplitude"});
    const bool own = entry.attribute("amplitude").value() == std::string("default");
    if (own) remark_once(xml.remarks, "the device's own amplitude is taken as 255");
    const double amplitude = own ? 255.0 : attribute_number(xml, entry, "amplitude", {0.0, 255.0});
    const double length_s = length_s_of(xml, entry, 0.0);
    const double acceleration_g = continuous_g(xml.file.map, amplitude / 255.0);
    if (!(length_s > 0.0)) return;
    line_to(xml.voice, xml.voice.end_s + length_s, acceleration_g, kUnknownHz, acceleration_g,
            kUnknownHz);
}

void read_entries(XmlReading& xml, const pugi::xml_node& node) {
    if (!has_only(xml, node, "waveform-entry")) return;
    for (const pugi::xml_node& entry : node.children()) read_entry(xml, entry);
    remark_once(xml.remarks, "165 Hz are guessed: such effects have no frequency");
}

void remark_repeats(XmlReading& xml) {
    remark_once(xml.remarks, "repeats for ever in its player; once here");
}

void read_waveform(XmlReading& xml, const pugi::xml_node& node) {
    check_attributes(xml, node, {});
    const double start_s = xml.voice.end_s;
    for (const pugi::xml_node& child : node.children()) {
        const std::string name = child.name();
        if (name == "repeating" && child == node.last_child()) {
            check_attributes(xml, child, {});
            read_entries(xml, child);
            remark_repeats(xml);
        } else if (name == "waveform-entry") {
            read_entry(xml, child);
        } else {
            refuse_node(
                xml, node,
                "expected <waveform-entry> and one <repeating> at the end, got " + in_quotes(name));
        }
    }
    if (!(xml.voice.end_s > start_s)) refuse_node(xml, node, "expected entries of more than 0 ms");
    remark_once(xml.remarks, "165 Hz are guessed: such effects have no frequency");
}

void read_one(XmlReading& xml, const pugi::xml_node& node);

// Entries of a waveform, or one effect.
void read_part(XmlReading& xml, const pugi::xml_node& part) {
    check_attributes(xml, part, {});
    const pugi::xml_node first = part.first_child();
    if (!first) return refuse_node(xml, part, "expected an effect, got none");
    if (first.name() == std::string("waveform-entry")) return read_entries(xml, part);
    if (first != part.last_child())
        return refuse_node(xml, part, "expected one effect, got several");
    read_one(xml, first);
}

// <repeating>, a <preamble> before it or none.
void read_repeating(XmlReading& xml, const pugi::xml_node& node) {
    check_attributes(xml, node, {});
    const double start_s = xml.voice.end_s;
    for (const pugi::xml_node& child : node.children()) {
        const std::string name = child.name();
        const bool fits = child == node.last_child()
                              ? name == "repeating"
                              : name == "preamble" && child == node.first_child();
        if (!fits) {
            return refuse_node(
                xml, node,
                "expected <preamble> or none and one <repeating>, got " + in_quotes(name));
        }
        read_part(xml, child);
    }
    if (!node.first_child()) return refuse_node(xml, node, "expected <repeating>, got none");
    if (!(xml.voice.end_s > start_s)) refuse_node(xml, node, "expected more than 0 ms");
    remark_repeats(xml);
}

void refuse_as_the_devices(XmlReading& xml, const pugi::xml_node& node) {
    xml.is_the_devices = xml.fault.empty();
    refuse_node(xml, node,
                "expected an envelope, a waveform or a named effect; this one's course is the "
                "device's own");
}

// Where the course ends.
double add_bursts_of(XmlReading& xml, const AssumedCourse& course, double start_s, double scale) {
    const ActuatorMap& map = xml.file.map;
    std::vector<Transient> bursts;
    double end_s = start_s;
    for (const CoursePoint& point : course.points) {
        const double at_s = start_s + point.time_s;
        end_s = at_s + point.burst_s;
        if (scale > 0.0) bursts.push_back(burst_at(map, point, at_s, scale));
    }
    add_bursts(xml.primitives.transients, bursts);
    return end_s;
}

double add_lines_of(XmlReading& xml, const AssumedCourse& course, double start_s, double scale) {
    AmplitudeCurve intensities;
    AmplitudeCurve sharpnesses;
    for (const CoursePoint& point : course.points) {
        intensities.push_back({start_s + point.time_s, scale * point.intensity});
        sharpnesses.push_back({start_s + point.time_s, point.sharpness});
    }
    Voice voice;
    voice.start_s = start_s;
    voice.end_s = start_s + course.points.back().time_s;
    voice.amplitude = acceleration_curve(xml.file.map, intensities);
    voice.frequency = frequency_curve(xml.file.map, sharpnesses);
    xml.primitives.voices.push_back(voice);
    return voice.end_s;
}

double add_course(XmlReading& xml, const AssumedCourse& course, double start_s, double scale) {
    const double end_s = course.bursts ? add_bursts_of(xml, course, start_s, scale)
                                       : add_lines_of(xml, course, start_s, scale);
    xml.primitives.duration_s = std::max(xml.primitives.duration_s, end_s);
    remark_once(xml.remarks,
                std::string(course.name) + ": the course is assumed, every device has its own");
    return end_s;
}

void read_predefined(XmlReading& xml, const pugi::xml_node& node) {
    check_attributes(xml, node, {"name"});
    const std::string name = node.attribute("name").value();
    const AssumedCourse* course = course_named(courses::kPredefined, name);
    if (course == nullptr) {
        return refuse_node(
            xml, node,
            "name: expected click, double_click, heavy_click or tick, got " + in_quotes(name));
    }
    add_course(xml, *course, 0.0, 1.0);
}

// When a primitive begins, after one from `last_s` to `end_s`.
double start_of(XmlReading& xml, const pugi::xml_node& node, double last_s, double end_s) {
    const double delay_s = node.attribute("delayMs")
                               ? attribute_number(xml, node, "delayMs", kEffectTimeMs) / 1e3
                               : 0.0;
    const std::string type = node.attribute("delayType").value();
    if (type == "relative_start_offset") return last_s + delay_s;
    if (node.attribute("delayType") && type != "pause") {
        refuse_node(xml, node,
                    "delayType: expected pause or relative_start_offset, got " + in_quotes(type));
    }
    return end_s + delay_s;
}

void read_primitives(XmlReading& xml, const pugi::xml_node& all) {
    if (!has_only(xml, all, "primitive-effect")) return;
    double start_s = 0.0;
    double end_s = 0.0;
    for (const pugi::xml_node& node : all.children()) {
        check_attributes(xml, node, {"name", "scale", "delayMs", "delayType"});
        const std::string name = node.attribute("name").value();
        const AssumedCourse* course = course_named(courses::kPrimitives, name);
        if (course == nullptr) {
            refuse_node(xml, node,
                        "name: expected click, low_tick, quick_fall, quick_rise, slow_rise, spin, "
                        "thud or tick, got " +
                            in_quotes(name));
        }
        const double scale =
            node.attribute("scale") ? attribute_number(xml, node, "scale", kShare) : 1.0;
        const double begin_s = start_of(xml, node, start_s, end_s);
        if (const std::string fault = pay_points(xml.file, 8); !fault.empty()) {
            refuse_node(xml, node, fault);
        }
        if (!xml.fault.empty()) return;
        if (begin_s < end_s - 1e-9) {
            remark_once(xml.remarks, name + ": overlaps the primitive before, is left out");
            continue;
        }
        start_s = begin_s;
        end_s = add_course(xml, *course, start_s, scale);
    }
}

void read_one(XmlReading& xml, const pugi::xml_node& node) {
    const std::string name = node.name();
    const bool nested = node.parent().name() != std::string("vibration-effect");
    if (name == "waveform-envelope-effect") return read_waveform_envelope(xml, node);
    if (name == "basic-envelope-effect") return read_basic_envelope(xml, node);
    if (name == "waveform-effect" && !nested) return read_waveform(xml, node);
    if (name == "repeating-effect" && !nested) return read_repeating(xml, node);
    if (name == "predefined-effect" && !nested) return read_predefined(xml, node);
    if (name == "primitive-effect" && !nested) return read_primitives(xml, node.parent());
    if (name == "vendor-effect") return refuse_as_the_devices(xml, node);
    refuse_node(xml, node.parent(),
                std::string("expected waveform-envelope-effect") +
                    (nested ? " or basic-envelope-effect"
                            : ", basic-envelope-effect, waveform-effect, repeating-effect, "
                              "predefined-effect or primitive-effect") +
                    ", got " + in_quotes(name));
}

struct Vibration {
    std::optional<Effect> effect;  // none: the device's own, for this reason
    std::string reason;
};

Expected<Vibration> read_vibration(const pugi::xml_node& node, const std::string& name,
                                   const EffectFile& file) {
    XmlReading xml{file, {}, {}, {}, {}};
    check_attributes(xml, node, {});
    const pugi::xml_node first = node.first_child();
    if (!first) refuse_node(xml, node, "expected an effect, got none");
    const bool composed = first.name() == std::string("primitive-effect");
    if (first != node.last_child() && !composed) {
        refuse_node(xml, node, "expected one effect, got several");
    }
    if (xml.fault.empty()) read_one(xml, first);
    if (xml.is_the_devices) return Vibration{std::nullopt, xml.fault};
    if (!xml.fault.empty()) return Error{xml.fault};
    Sketch sketch = std::move(xml.primitives);
    sketch.unit_g = continuous_g(file.map, 1.0);
    if (!xml.voice.frequency.empty()) sketch.voices.push_back(std::move(xml.voice));
    auto effect = finished(file, name, sketch, std::move(xml.remarks));
    if (!effect) return effect.error();
    return Vibration{*std::move(effect), {}};
}

// What is wrong with what stands around the root, or empty.
std::string root_fault(const pugi::xml_document& document) {
    const pugi::xml_node root = document.document_element();
    const std::string name = root.name();
    if (name == "vibration") {
        return "/: expected <vibration-effect> or <vibration-select>, got \"vibration\", as older "
               "versions of Android have it";
    }
    if (name != "vibration-select" && name != "vibration-effect") {
        return "/: expected <vibration-effect> or <vibration-select>, got " + in_quotes(name);
    }
    for (const pugi::xml_node& node : document.children()) {
        if (node == root) continue;
        const bool is_element = node.type() == pugi::node_element;
        return "/: expected one <" + name + "> and nothing else, got " +
               in_quotes(is_element ? node.name() : trimmed(node.value()));
    }
    return {};
}

Expected<Effects> read_select(const pugi::xml_node& root, const EffectFile& file) {
    UnusedNames names;
    Effects effects;
    std::vector<std::string> reasons;
    for (const pugi::xml_node& node : root.children()) {
        if (node.name() != std::string("vibration-effect")) {
            return Error{file.path + ": " + root.path() + ": expected <vibration-effect>, got " +
                         in_quotes(node.name())};
        }
        auto vibration = read_vibration(node, names.unused(file.stem), file);
        if (!vibration) return vibration.error();
        if (vibration->effect) effects.push_back(*std::move(vibration->effect));
        if (!vibration->reason.empty()) reasons.push_back(vibration->reason);
    }
    if (effects.empty() && !reasons.empty()) return Error{reasons.front()};
    if (effects.empty()) {
        return Error{file.path + ": " + root.path() + ": expected <vibration-effect>, got none"};
    }
    if (reasons.empty()) return effects;
    effects.front().remarks.push_back(
        grouped_digits(reasons.size()) +
        " of its vibrations are left out: their courses are the device's own");
    return effects;
}

}  // namespace

bool is_android_xml(std::string_view text) {
    constexpr std::array<std::string_view, 4> kRoots{"<vibration-effect", "<vibration-select",
                                                     "<vibration>", "<vibration "};
    return std::ranges::any_of(kRoots,
                               [&](std::string_view root) { return text.find(root) != text.npos; });
}

Expected<Effects> read_android_xml(std::string_view text, const EffectFile& file) {
    pugi::xml_document document;
    const pugi::xml_parse_result parsed =
        document.load_buffer(text.data(), text.size(), pugi::parse_default | pugi::parse_fragment);
    if (!parsed) {
        const TextPosition at =
            position_of(text, std::min(static_cast<std::size_t>(parsed.offset), text.size()));
        return Error{file.path + ", line " + std::to_string(at.line) + ", column " +
                     std::to_string(at.column) + ": expected XML: " + parsed.description()};
    }
    if (const std::string fault = root_fault(document); !fault.empty()) {
        return Error{file.path + ": " + fault};
    }
    const pugi::xml_node root = document.document_element();
    if (root.name() == std::string("vibration-select")) return read_select(root, file);
    auto vibration = read_vibration(root, file.stem, file);
    if (!vibration) return vibration.error();
    if (!vibration->effect) return Error{vibration->reason};
    return Effects{*std::move(vibration->effect)};
}

}  // namespace tact
