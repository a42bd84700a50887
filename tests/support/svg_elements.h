// A small strict reader of the XML that SVG pictures are written in.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <vector>

struct SvgElement {
    std::string name;
    std::map<std::string, std::string> attributes;
    std::string text;                // directly inside, with entities resolved
    std::vector<std::string> above;  // names of what it is in, the outermost first

    double number(const std::string& attribute) const {
        REQUIRE_MESSAGE(attributes.contains(attribute), name << " lacks " << attribute);
        return std::stod(attributes.at(attribute));
    }
    std::string value(const std::string& attribute) const {
        const auto found = attributes.find(attribute);
        return found == attributes.end() ? "" : found->second;
    }
};

inline std::string resolved(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        REQUIRE(text[i] != '<');
        if (text[i] != '&') {
            result += text[i];
            continue;
        }
        const std::size_t end = text.find(';', i);
        REQUIRE(end != text.npos);
        const std::map<std::string_view, char> known{{"amp", '&'}, {"lt", '<'}, {"gt", '>'}};
        const auto entity = known.find(text.substr(i + 1, end - i - 1));
        REQUIRE(entity != known.end());
        result += entity->second;
        i = end;
    }
    return result;
}

// The name and the attributes of what stands between < and > or />.
inline SvgElement element_of(std::string_view tag) {
    SvgElement element;
    std::size_t at = std::min(tag.find(' '), tag.size());
    element.name = tag.substr(0, at);
    REQUIRE_FALSE(element.name.empty());
    while (at < tag.size()) {
        REQUIRE(tag[at] == ' ');
        const std::size_t equals = tag.find("=\"", at);
        REQUIRE(equals != tag.npos);
        const std::size_t end = tag.find('"', equals + 2);
        REQUIRE(end != tag.npos);
        const std::string name(tag.substr(at + 1, equals - at - 1));
        REQUIRE(name.find_first_of(" =\"<>&") == std::string::npos);
        const std::string value = resolved(tag.substr(equals + 2, end - equals - 2));
        REQUIRE_MESSAGE(element.attributes.insert({name, value}).second, "twice: " << name);
        at = end + 1;
    }
    return element;
}

// All elements in the order of their tags. Fails where tags do not balance under one root.
inline std::vector<SvgElement> elements_of(std::string_view xml) {
    std::vector<SvgElement> elements;
    std::vector<std::size_t> open;
    while (!xml.empty()) {
        const std::size_t less = std::min(xml.find('<'), xml.size());
        const std::string text = resolved(xml.substr(0, less));
        if (open.empty()) {
            REQUIRE(text.find_first_not_of('\n') == std::string::npos);
        } else {
            elements[open.back()].text += text;
        }
        xml.remove_prefix(less);
        if (xml.empty()) break;
        const std::size_t greater = xml.find('>');
        REQUIRE(greater != xml.npos);
        std::string_view tag = xml.substr(1, greater - 1);
        xml.remove_prefix(greater + 1);
        if (tag.starts_with('/')) {
            REQUIRE_FALSE(open.empty());
            REQUIRE(elements[open.back()].name == tag.substr(1));
            open.pop_back();
            continue;
        }
        const bool closed = tag.ends_with('/');
        if (closed) tag.remove_suffix(1);
        REQUIRE((!open.empty() || elements.empty()));
        SvgElement element = element_of(tag);
        for (const std::size_t i : open) element.above.push_back(elements[i].name);
        elements.push_back(std::move(element));
        if (!closed) open.push_back(elements.size() - 1);
    }
    REQUIRE(open.empty());
    REQUIRE_FALSE(elements.empty());
    return elements;
}

inline std::vector<SvgElement> elements_of(std::string_view xml, const std::string& name) {
    std::vector<SvgElement> all = elements_of(xml);
    std::erase_if(all, [&](const SvgElement& e) { return e.name != name; });
    return all;
}

// How often a text stands in the picture as an element of its own.
inline std::ptrdiff_t text_count(std::string_view xml, const std::string& text) {
    const auto texts = elements_of(xml, "text");
    return std::ranges::count(texts, text, &SvgElement::text);
}
