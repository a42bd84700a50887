#include "app/report/html.h"

#include <doctest/doctest.h>

#include "app/report/html_map.h"
#include "tests/support/svg_elements.h"

namespace html_test {

using namespace tact;

namespace {

std::size_t times(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
        ++count;
    }
    return count;
}

}  // namespace

TEST_CASE("html: no name breaks out of the place where it is written") {
    CHECK(html_escaped("a < b & \"c\" > 'd'") == "a &lt; b &amp; &quot;c&quot; &gt; &#39;d&#39;");
    CHECK(html_escaped("\xC3\xA4 \xE2\x82\xAC") == "\xC3\xA4 \xE2\x82\xAC");
    CHECK(html_escaped("\xFF").find('\xFF') == std::string::npos);
    CHECK(html_escaped(std::string("a\0b", 3)).find('\0') == std::string::npos);
    const HtmlPage page{.title = "</title><script>", .body = html_section("\"><b>", "<i>", "")};
    for (const char* tag : {"<script>", "<b>", "<i>"}) {
        CHECK(times(html_of(page), tag) == 0);
    }
}

TEST_CASE("html: a table has its heads once and a cell for every column of every row") {
    const std::string html =
        html_of(HtmlTable{.columns = {{"name"}, {"g & g", true}},
                          .rows = {{"<b>one</b>", "1"}, {"two", "2"}, {"three", "3"}},
                          .kind = "wide"});
    CHECK(times(html, "<th") - times(html, "<thead") == 2);
    CHECK(times(html, "<td") == 6);
    CHECK(times(html, "<td class=\"number\">") == 3);
    CHECK(times(html, "g &amp; g") == 1);
    CHECK(times(html, "<td><b>one</b></td>") == 1);
    CHECK(times(html, "<table class=\"wide\">") == 1);
}

TEST_CASE("html: a page forbids itself to fetch or to run anything, and names no other file") {
    const std::string html = html_of(HtmlPage{.title = "Report", .body = "<p>text</p>"});
    CHECK(times(html, "default-src 'none'") == 1);
    CHECK(times(html, "script-src") == 0);  // so none runs
    for (const char* way_out : {"http://", "https://", "src=", "href=", "@import", "url("}) {
        CHECK(times(html, way_out) == 0);
    }
    CHECK(times(html, "prefers-color-scheme:dark") == 1);
    CHECK(times(html, "size:A4") == 1);
}

TEST_CASE("html: a map is there on either ground, with arrows from where the points were") {
    PatternSet set;
    for (const char* name : {"one", "two", "three"}) {
        Vibration vibration;
        vibration.name = name;
        set.vibrations.push_back(vibration);
    }
    const Dissimilarity apart{3, {1.0, 2.0, 3.0}};
    PerceptualSpace space;
    space.points.resize(3, 3);
    space.points << 0.0, 0.0, 0.0, 1.0, 0.2, 0.0, -0.6, 0.9, 0.3;
    const Eigen::MatrixXd before = space.points.array() + 0.5;
    const std::string still = html_of(HtmlMap{.set = set, .dissimilarity = apart, .space = space});
    CHECK(times(still, "<svg") == 2);
    CHECK(times(still, "xmlns=") == 0);
    CHECK(times(still, "viewBox=\"0 0 760 480\"") == 2);
    const std::string moved = html_of(
        HtmlMap{.set = set, .dissimilarity = apart, .space = space, .marks = {.before = &before}});
    const auto shapes = [](const std::string& html) {
        return elements_of(html, "path").size() + elements_of(html, "circle").size();
    };
    // A line, a ring and a head for each point, on two grounds; lines of one colour may be one
    // path.
    CHECK(shapes(moved) >= shapes(still) + 2 * 3);
    CHECK(times(moved, "id=\"clip1\"") == 0);  // two drawings of one page share no names
}

}  // namespace html_test
