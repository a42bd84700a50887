// Android's vibrations as XML: <vibration-effect>, or several in a <vibration-select>.
//
// Source    the platform's own parser and its tests (API 36, Apache-2.0). An envelope of waveforms:
//           amplitude and Hz straight between points, from amplitude 0 and the first point's Hz. A
//           basic envelope: sharpness straight from the lowest to the highest Hz, intensity a share
//           of the greatest level (dB) above threshold, 0 at its end.
// Guessed   that greatest level, which is the device's (ActuatorMap::sensation_db), at any Hz; the
//           Hz of waveform-effects; the device's own amplitude: the greatest.
// Refused   what the platform's parser refuses; predefined effects, primitives and effects of
//           vendors: their courses are the device's.
// Left out  repetition: once.

#include <algorithm>
#include <pugixml.hpp>
#include <string>

#include "model/common/portable.h"
#include "model/io/effects/formats.h"
#include "model/text/numbers.h"
#include "model/text/unique_names.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

constexpr double kUnknownHz = 165.0;
constexpr Range kXmlHz{0.001, 1e6};

struct XmlReading {
    const EffectFile& file;
    std::string fault;
    std::vector<std::string> remarks;
    Voice voice;  // of the effect that is read, as far as it is
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
    if (!has_only(xml, node, "control-point")) return;
    const bool initial = !node.attribute("initialFrequencyHz").empty();
    double hz = initial ? attribute_number(xml, node, "initialFrequencyHz", kXmlHz)
                        : attribute_number(xml, node.first_child(), "frequencyHz", kXmlHz);
    double amplitude_g = 0.0;
    const ActuatorMap& map = xml.file.map;
    for (const pugi::xml_node& point : node.children()) {
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
    if (!has_only(xml, node, "control-point")) return;
    const ActuatorMap& map = xml.file.map;
    const bool initial = !node.attribute("initialSharpness").empty();
    const double sharpness = initial
                                 ? attribute_number(xml, node, "initialSharpness", kShare)
                                 : attribute_number(xml, node.first_child(), "sharpness", kShare);
    AmplitudeCurve intensities{{xml.voice.end_s, 0.0}};
    AmplitudeCurve sharpnesses{{xml.voice.end_s, sharpness}};
    for (const pugi::xml_node& point : node.children()) {
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
    const bool own = entry.attribute("amplitude").value() == std::string("default");
    if (own) remark_once(xml.remarks, "the device's own amplitude is taken as 255");
    const double amplitude = own ? 255.0 : attribute_number(xml, entry, "amplitude", {0.0, 255.0});
    const double length_s = length_s_of(xml, entry, 0.0);
    const double acceleration_g = continuous_g(xml.file.map, amplitude / 255.0);
    if (!(length_s > 0.0)) return;
    line_to(xml.voice, xml.voice.end_s + length_s, acceleration_g, kUnknownHz, acceleration_g,
            kUnknownHz);
}

void read_waveform(XmlReading& xml, const pugi::xml_node& node) {
    const double start_s = xml.voice.end_s;
    for (const pugi::xml_node& child : node.children()) {
        const std::string name = child.name();
        if (name == "repeating" && child == node.last_child()) {
            if (!has_only(xml, child, "waveform-entry")) return;
            remark_once(xml.remarks, "repeats for ever in its player; once here");
            for (const pugi::xml_node& entry : child.children()) read_entry(xml, entry);
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

void read_repeating(XmlReading& xml, const pugi::xml_node& node) {
    for (const pugi::xml_node& child : node.children()) {
        const std::string name = child.name();
        if (name != "preamble" && name != "repeating") {
            return refuse_node(xml, node,
                               "expected <preamble> and <repeating>, got " + in_quotes(name));
        }
        for (const pugi::xml_node& effect : child.children()) read_one(xml, effect);
    }
    if (!node.child("repeating")) return refuse_node(xml, node, "expected <repeating>, got none");
    remark_once(xml.remarks, "repeats for ever in its player; once here");
}

void read_one(XmlReading& xml, const pugi::xml_node& node) {
    const std::string name = node.name();
    const bool nested = node.parent().name() != std::string("vibration-effect");
    if (name == "waveform-envelope-effect") return read_waveform_envelope(xml, node);
    if (name == "basic-envelope-effect") return read_basic_envelope(xml, node);
    if (name == "waveform-effect" && !nested) return read_waveform(xml, node);
    if (name == "repeating-effect" && !nested) return read_repeating(xml, node);
    if (name == "predefined-effect" || name == "primitive-effect" || name == "vendor-effect") {
        return refuse_node(xml, node,
                           "expected an envelope or a waveform; this one's course is the device's "
                           "own");
    }
    refuse_node(xml, node.parent(),
                "expected waveform-envelope-effect, basic-envelope-effect, waveform-effect or "
                "repeating-effect, got " +
                    in_quotes(name));
}

Expected<Effect> read_vibration(const pugi::xml_node& node, const std::string& name,
                                const EffectFile& file) {
    XmlReading xml{file, {}, {}, {}};
    if (!node.first_child()) refuse_node(xml, node, "expected an effect, got none");
    if (node.first_child() != node.last_child()) {
        refuse_node(xml, node, "expected one effect, got several");
    }
    if (xml.fault.empty()) read_one(xml, node.first_child());
    if (!xml.fault.empty()) return Error{xml.fault};
    Sketch sketch;
    sketch.unit_g = continuous_g(file.map, 1.0);
    sketch.voices.push_back(std::move(xml.voice));
    return finished(file, name, sketch, std::move(xml.remarks));
}

}  // namespace

Expected<Effects> read_android_xml(std::string_view text, const EffectFile& file) {
    pugi::xml_document document;
    const pugi::xml_parse_result parsed = document.load_buffer(text.data(), text.size());
    if (!parsed) {
        const TextPosition at =
            position_of(text, std::min(static_cast<std::size_t>(parsed.offset), text.size()));
        return Error{file.path + ", line " + std::to_string(at.line) + ", column " +
                     std::to_string(at.column) + ": expected XML: " + parsed.description()};
    }
    const pugi::xml_node root = document.document_element();
    UnusedNames names;
    Effects effects;
    const bool several = root.name() == std::string("vibration-select");
    if (!several && root.name() != std::string("vibration-effect")) {
        return Error{file.path + ": /: expected <vibration-effect> or <vibration-select>, got " +
                     in_quotes(root.name())};
    }
    for (pugi::xml_node node = several ? root.first_child() : root; node;
         node = several ? node.next_sibling() : pugi::xml_node()) {
        if (node.name() != std::string("vibration-effect")) {
            return Error{file.path + ": " + root.path() + ": expected <vibration-effect>, got " +
                         in_quotes(node.name())};
        }
        auto effect = read_vibration(node, names.unused(file.stem), file);
        if (!effect) return effect.error();
        effects.push_back(*std::move(effect));
    }
    if (effects.empty()) {
        return Error{file.path + ": " + root.path() + ": expected <vibration-effect>, got none"};
    }
    return effects;
}

}  // namespace tact
