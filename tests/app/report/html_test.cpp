#include "app/report/report.h"

#include <doctest/doctest.h>

#include "tests/support/svg_elements.h"
#include "tests/support/times_in.h"

namespace html_test {

using namespace tact;

TEST_CASE("html: no name breaks out of the place where it is written") {
    CHECK(html_escaped("a < b & \"c\" > 'd'") == "a &lt; b &amp; &quot;c&quot; &gt; &#39;d&#39;");
    CHECK(html_escaped("\xC3\xA4 \xE2\x82\xAC") == "\xC3\xA4 \xE2\x82\xAC");
    CHECK(html_escaped("\xFF").find('\xFF') == std::string::npos);
    CHECK(html_escaped(std::string("a\0b", 3)).find('\0') == std::string::npos);
    const HtmlPage page{.title = "</title><script>", .body = html_section("\"><b>", "<i>", "")};
    for (const char* tag : {"<script>", "<b>", "<i>"}) {
        CHECK(times_in(html_of(page), tag) == 0);
    }
}

TEST_CASE("html: a table has its heads once and a cell for every column of every row") {
    const std::string html =
        html_of(HtmlTable{.columns = {{"name"}, {"g & g", true}},
                          .rows = {{"<b>one</b>", "1"}, {"two", "2"}, {"three", "3"}},
                          .kind = "wide"});
    CHECK(times_in(html, "<th") - times_in(html, "<thead") == 2);
    CHECK(times_in(html, "<td") == 6);
    CHECK(times_in(html, "<td class=\"number\">") == 3);
    CHECK(times_in(html, "g &amp; g") == 1);
    CHECK(times_in(html, "<td><b>one</b></td>") == 1);
    CHECK(times_in(html, "<table class=\"wide\">") == 1);
}

TEST_CASE("html: a page forbids itself to fetch or to run anything, and names no other file") {
    const std::string html = html_of(HtmlPage{.title = "Report", .body = "<p>text</p>"});
    CHECK(times_in(html, "default-src 'none'") == 1);
    CHECK(times_in(html, "script-src") == 0);  // so none runs
    for (const char* way_out : {"http://", "https://", "src=", "href=", "@import", "url("}) {
        CHECK(times_in(html, way_out) == 0);
    }
    CHECK(times_in(html, "prefers-color-scheme:dark") == 1);
    CHECK(times_in(html, "size:A4") == 1);
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
    CHECK(times_in(still, "<svg") == 2);
    CHECK(times_in(still, "xmlns=") == 0);
    CHECK(times_in(still, "viewBox=\"0 0 760 480\"") == 2);
    const std::string moved = html_of(
        HtmlMap{.set = set, .dissimilarity = apart, .space = space, .marks = {.before = &before}});
    const auto shapes = [](const std::string& html) {
        return elements_of(html, "path").size() + elements_of(html, "circle").size();
    };
    // A line, a ring and a head for each point, on two grounds; lines of one colour may be one
    // path.
    CHECK(shapes(moved) >= shapes(still) + 2 * 3);
    CHECK(times_in(moved, "id=\"clip1\"") == 0);  // two drawings of one page share no names
}

}  // namespace html_test
