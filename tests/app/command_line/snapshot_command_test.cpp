// tactspace snapshot, and --image: pictures from the command line.
#include <nlohmann/json.hpp>
#include <set>

#include "tests/support/five_patterns.h"
#include "tests/support/places.h"
#include "tests/support/run_program.h"
#include "tests/support/svg_elements.h"
#include "tests/support/temporary_folder.h"

namespace snapshot_command_test {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using tact::ShortSet;

namespace {

std::uint32_t big_endian(const std::string& bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t k = at; k < at + 4; ++k) {
        value = value << 8 | static_cast<unsigned char>(bytes.at(k));
    }
    return value;
}

}  // namespace

TEST_CASE("snapshot: every view is a PNG of the size asked for, the same each time" *
          doctest::test_suite("long")) {
    const ShortSet set;
    const TemporaryFolder folder;
    for (const std::string view :
         {"window", "wave", "spectrum", "firing", "tables", "matrix", "space"}) {
        CAPTURE(view);
        const fs::path file = folder.path / (view + ".png");
        const auto draw = [&](const char* theme) {
            output_of({"snapshot", set.path, "--view", view, "--width", "640", "--height", "430",
                       "--theme", theme, "--out", file.string()});
            return bytes_of(file);
        };
        const std::string dark = draw("dark");
        CHECK(dark.starts_with("\x89PNG\r\n\x1a\n"));
        CHECK(big_endian(dark, 16) == 640);
        CHECK(big_endian(dark, 20) == 430);
        CHECK(contains(dark.substr(dark.size() - 12), "IEND"));
        CHECK((draw("light") != dark));
        CHECK((draw("dark") == dark));
    }
}

TEST_CASE("snapshot: a name that ends in .svg gives well-formed SVG, the same each time" *
          doctest::test_suite("long")) {
    const ShortSet set;
    const TemporaryFolder folder;
    for (const std::string view :
         {"window", "wave", "spectrum", "firing", "tables", "matrix", "space"}) {
        CAPTURE(view);
        const fs::path file = folder.path / (view + ".SVG");
        const auto draw = [&](const char* theme) {
            output_of({"snapshot", set.path, "--view", view, "--width", "640", "--height", "430",
                       "--theme", theme, "--out", file.string()});
            return bytes_of(file);
        };
        const std::string dark = draw("dark");
        const auto elements = elements_of(dark);
        CHECK(elements.front().name == "svg");
        CHECK(elements.front().value("viewBox") == "0 0 640 430");
        CHECK(elements.size() > 20);
        CHECK((draw("light") != dark));
        CHECK((draw("dark") == dark));
    }
}

TEST_CASE("snapshot: physiology is drawn at a time, of one stage, of two patterns, tilted" *
          doctest::test_suite("long")) {
    const ShortSet set;
    const TemporaryFolder folder;
    const fs::path file = folder.path / "view.png";
    const auto draw = [&](const std::vector<std::string>& more, const char* width = "600") {
        std::vector<std::string> arguments{"snapshot", set.path, "--width", width,
                                           "--height", "600",    "--out",   file.string()};
        arguments.insert(arguments.end(), more.begin(), more.end());
        output_of(arguments);
        return bytes_of(file);
    };
    for (const std::string view : {"physiology", "window"}) {
        CAPTURE(view);
        const std::string plain = draw({"--view", view});
        CHECK((draw({"--view", view, "--at", "0", "--pattern", "v 1"}) == plain));
        std::set<std::string> different{plain};
        different.insert(draw({"--view", view, "--at", "0.05"}));
        different.insert(draw({"--view", view, "--pattern", "v 2"}));
        different.insert(draw({"--view", view, "--with", "v 2"}));
        different.insert(draw({"--view", view, "--stage", "receptors"}));
        different.insert(draw({"--view", view, "--stage", "receptors", "--tilted"}));
        CHECK(different.size() == 6);
    }
    // As narrow as a phone it shows one pane: that of the stage.
    const std::string narrow = draw({"--view", "window"}, "390");
    CHECK(draw({"--view", "window", "--stage", "receptors"}, "390") != narrow);
}

TEST_CASE("snapshot --frames: as many whole pictures as asked for, the same bytes each time" *
          doctest::test_suite("long")) {
    const ShortSet set;
    const TemporaryFolder folder;
    const auto draw = [&](const std::string& name, const std::vector<std::string>& more) {
        const fs::path out = folder.path / name;
        std::vector<std::string> arguments{"snapshot", set.path, "--view",   "physiology",
                                           "--width",  "300",    "--height", "400",
                                           "--frames", "4",      "--out",    out.string()};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Ran ran = run_program(arguments);
        CHECK(ran.exit_code == 0);
        CHECK(ran.out == "");
        CHECK(contains(ran.err, "tactspace: wrote 4 frames, in a film 1.33 times slower"));
        CHECK(contains(ran.err, "ffmpeg -framerate 30 -i " + out.string() + "/frame_%04d.png"));
        CHECK(file_count(out) == 4);
        std::vector<std::string> frames;
        for (const char* k : {"1", "2", "3", "4"}) {
            frames.push_back(bytes_of(out / (std::string("frame_000") + k + ".png")));
            CHECK(contains(frames.back().substr(frames.back().size() - 12), "IEND"));
        }
        return frames;
    };
    const auto frames = draw("a", {});
    CHECK(std::set<std::string>(frames.begin(), frames.end()).size() == 4);
    CHECK((draw("b", {"--from", "0", "--to", "0.1"}) == frames));
    CHECK((draw("a", {}) == frames));  // over the first ones
    const fs::path single = folder.path / "single.png";
    output_of({"snapshot", set.path, "--view", "physiology", "--width", "300", "--height", "400",
               "--at", "0.05", "--out", single.string()});
    CHECK((bytes_of(single) == frames[2]));
}

TEST_CASE("snapshot --frames: Ctrl+C ends it after a whole frame" * doctest::test_suite("long")) {
    const ShortSet set;
    const TemporaryFolder folder;
    const fs::path out = folder.path / "out";
    const Ran ran = run_program(
        {"snapshot", set.path, "--view", "physiology", "--frames", "9999", "--out", out.string()},
        "me=$$; (while kill -0 $me && [ ! -e '" + (out / "frame_0002.png").string() +
            "' ]; do sleep 0.01; done; kill -INT $me) >/dev/null 2>&1 & :");
    CHECK(ran.exit_code == 130);
    CHECK(contains(ran.err, "of 9999 frames written, each of them whole\n"));
    CHECK(file_count(out) >= 2);
    for (const auto& entry : fs::directory_iterator(out)) {
        const std::string bytes = bytes_of(entry.path());
        CHECK(entry.path().extension() == ".png");
        CHECK(contains(bytes.substr(bytes.size() - 12), "IEND"));
    }
}

TEST_CASE("--image: a picture beside the numbers, which stay the same" *
          doctest::test_suite("long")) {
    const ShortSet set;
    const TemporaryFolder folder;
    for (const std::string command : {"predict", "space"}) {
        const fs::path file = folder.path / (command + ".png");
        CHECK(output_of({command, set.path, "--image", file.string()}) ==
              output_of({command, set.path}));
        CHECK(bytes_of(file).starts_with("\x89PNG\r\n\x1a\n"));
        const fs::path vector_file = folder.path / (command + ".svg");
        output_of({command, set.path, "--image", vector_file.string()});
        CHECK(elements_of(bytes_of(vector_file), "text").size() > 2);
    }
}

TEST_CASE("snapshot --figures: every stage is an SVG of its own") {
    const ShortSet set;
    const TemporaryFolder folder;
    const fs::path out = folder.path / "figures";
    const auto ran = run_program({"snapshot", set.path, "--view", "physiology", "--figures",
                                  "--theme", "light", "--out", out.string()});
    REQUIRE_MESSAGE(ran.exit_code == 0, ran.err);
    for (const char* stage : {"vibration", "spectrum", "receptors", "brain", "envelope"}) {
        CHECK(contains(bytes_of(out / (std::string(stage) + ".svg")), "<svg"));
    }
}

TEST_CASE("snapshot: a film needs to know how slow it is, and one way of saying it") {
    const ShortSet set;
    const TemporaryFolder folder;
    const std::string out = (folder.path / "a.gif").string();
    const auto refusal = [&](std::vector<std::string> more) {
        std::vector<std::string> all{"snapshot", set.path, "--view", "physiology", "--out", out};
        all.insert(all.end(), more.begin(), more.end());
        const auto ran = run_program(all);
        CHECK(ran.exit_code == 1);
        CHECK_FALSE(fs::exists(out));
        return ran.err;
    };
    CHECK(contains(refusal({}), ".gif needs --slower or --frames"));
    CHECK(contains(refusal({"--slower", "2", "--frames", "3"}), "expected one of the two"));
    CHECK(contains(refusal({"--figures", "--slower", "2"}), "--figures"));
}

}  // namespace snapshot_command_test
