// Bad input and bad usage through the whole program: one sentence, nothing on standard output,
// nothing lost.
#include <doctest/doctest.h>

#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wave_bytes.h"

namespace refusals_test {

namespace fs = std::filesystem;

namespace {

constexpr const char* kPair = R"({"tactspace": 1, "patterns": [
    {"name": "a", "duration_s": 0.05},
    {"name": "b", "duration_s": 0.05, "amplitude_g": 2}]})";

struct Folder : TemporaryFolder {
    std::string at(const std::string& name) const { return (path / name).string(); }

    // What predict says of a file with these bytes.
    std::string refusal(const std::string& name, std::string_view bytes) const {
        return refusal_of({"predict", write(name, bytes).string()});
    }
};

// What predict says of a set whose only pattern has these fields, without the file's name.
std::string refusal_of_fields(const std::string& fields) {
    const Folder folder;
    const std::string sentence = folder.refusal(
        "set.json", R"({"tactspace": 1, "patterns": [{"name": "a", )" + fields + "}]}");
    const std::string head = "tactspace: " + folder.at("set.json") + ": ";
    CHECK_MESSAGE(sentence.starts_with(head), sentence);
    return sentence.substr(std::min(head.size(), sentence.size()));
}

}  // namespace

TEST_CASE("refusals: what is not there is named") {
    const Folder folder;
    CHECK(refusal_of({"predict", folder.at("gone.json")}) ==
          "tactspace: " + folder.at("gone.json") + ": there is no such file\n");
    CHECK(refusal_of({"predict", folder.path.string()}) ==
          "tactspace: " + folder.path.string() +
              ": expected at least one .txt or .wav or effect file in this folder, got none\n");
    const std::string sentence = folder.refusal(
        "set.json", R"({"tactspace": 1, "patterns": [{"name": "a", "waveform": "gone.wav"}]})");
    CHECK(contains(sentence, "set.json: /patterns/0/waveform of \"a\": "));
    CHECK(contains(sentence, "gone.wav: there is no such file"));
    folder.write("pair.json", kPair);
    CHECK(contains(
        refusal_of({"stages", folder.at("pair.json"), "--pattern", "c", "--out", folder.at("out")}),
        "there is no pattern \"c\", expected one of a, b"));
    CHECK_FALSE(fs::exists(folder.at("out")));
}

TEST_CASE("refusals: a matrix or a map of fewer than two patterns") {
    const Folder folder;
    const std::string one = folder.write("one.txt", "1\n2\n").string();
    const std::string none = folder.write("none.json", R"({"tactspace": 1, "patterns": []})");
    for (const std::string command : {"predict", "space"}) {
        CHECK(refusal_of({command, one}) ==
              "tactspace: " + one + ": has a single pattern, expected at least two to compare\n");
        CHECK(contains(refusal_of({command, none}), "none.json: has no pattern, expected at "));
    }
    CHECK(contains(refusal_of({"snapshot", one, "--view", "space", "--out", folder.at("a.png")}),
                   "has a single pattern"));
    CHECK_FALSE(fs::exists(folder.at("a.png")));
}

TEST_CASE("refusals: a waveform of words, of NaN, of infinity or of nothing, with its line") {
    const Folder folder;
    CHECK(contains(folder.refusal("v.txt", "0\n1\nhello\n"),
                   "v.txt:3: expected one finite number, got \"hello\"\n"));
    CHECK(contains(folder.refusal("v.txt", "0\nnan\n"), "v.txt:2: expected one finite number"));
    CHECK(contains(folder.refusal("v.txt", "0\n\n-inf\n"), "v.txt:2: "));
    CHECK(contains(folder.refusal("v.txt", "inf\n"), "v.txt:1: expected one finite number"));
    CHECK(contains(folder.refusal("v.txt", "1e999\n"), "v.txt:1: expected one finite number"));
    CHECK(contains(folder.refusal("v.txt", "1 2\n"), "v.txt:1: expected one finite number"));
    CHECK(contains(folder.refusal("v.txt", "0,5\n"), "v.txt:1: expected one finite number"));
    CHECK(contains(folder.refusal("v.txt", ""), "v.txt:1: expected at least one sample"));
    CHECK(contains(folder.refusal("v.txt", "\n\n"), "v.txt:1: expected at least one sample"));
    // The same file in a folder with a good one: it is named, and one is left to compare.
    folder.write("w.txt", "1\n");
    const Ran ran = run_program({"predict", folder.path.string()});
    CHECK(ran.exit_code == 1);
    CHECK(contains(ran.err, "v.txt:1: expected at least one sample"));
    CHECK(contains(ran.err, "expected at least two to compare"));
}

TEST_CASE("refusals: WAV files that are cut, empty, not finite, or none" *
          doctest::test_suite("long")) {
    const Folder folder;
    WaveBytes wave;
    wave.bits = 32;
    wave.is_float = true;
    wave.samples = std::vector<double>(100, 0.5);
    const std::string whole = wave.file();
    for (std::size_t length = 0; length < whole.size(); length += 7) {
        CAPTURE(length);
        CHECK(contains(folder.refusal("cut.wav", whole.substr(0, length)), "cut.wav: "));
    }
    CHECK(contains(folder.refusal("cut.wav", whole.substr(0, whole.size() - 100)),
                   "is truncated: expected 400 bytes of samples, as its header says, got 300"));
    wave.samples[41] = std::nan("");
    CHECK(contains(folder.refusal("nan.wav", wave.file()), "nan.wav: sample 42 is nan"));
    wave.samples[41] = HUGE_VAL;
    CHECK(contains(folder.refusal("inf.wav", wave.file()), "inf.wav: sample 42 is inf"));
    wave.samples.clear();
    CHECK(contains(folder.refusal("empty.wav", wave.file()), "expected at least one sample"));
    CHECK(contains(folder.refusal("text.wav", "hello"), "text.wav: expected a WAV file"));
}

TEST_CASE("refusals: names that are there twice") {
    const Folder folder;
    const std::string twice = R"({"tactspace": 1, "patterns": [{"name": "a"}, {"name": "a"}]})";
    CHECK(contains(folder.refusal("set.json", twice),
                   "set.json: /patterns/1/name: \"a\" is the name of /patterns/0 too"));
    const std::string pair = folder.write("pair.json", kPair).string();
    const std::string other = folder.write("a.txt", "1\n").string();
    CHECK(contains(refusal_of({"predict", pair, other}), "a.txt: \"a\" is a name in " + pair));
}

TEST_CASE("refusals: JSON that is cut, too deep, of a newer format, or something else") {
    const Folder folder;
    const std::string whole = kPair;
    for (std::size_t length = 0; length < whole.size(); length += 11) {
        CAPTURE(length);
        CHECK(contains(folder.refusal("cut.json", whole.substr(0, length)), "cut.json, line "));
    }
    for (const char* bracket : {"[", "{\"a\":"}) {
        std::string deep = R"({"tactspace": 1, "patterns": )";
        for (int k = 0; k < 200'000; ++k) deep += bracket;
        CHECK(contains(folder.refusal("deep.json", deep), "deep.json, line 1, column "));
    }
    CHECK(contains(folder.refusal("newer.json", R"({"tactspace": 2, "patterns": 7})"),
                   "newer.json: made by a newer version (format 2); this program reads format 1"));
    CHECK(contains(folder.refusal("list.json", R"(["a", 2])"), "list.json: /: expected an object"));
    CHECK(contains(folder.refusal("other.json", R"({"name": "a package"})"),
                   "other.json: is not a set of tactspace"));
    CHECK(contains(folder.refusal("latin.json", "{\"tactspace\": 1, \"name\": \"Gr\xF6\"}"),
                   "latin.json, line 1, column 29: expected text in UTF-8"));
    CHECK(contains(folder.refusal("set.yaml", "patterns:"), "set.yaml: expected a set"));
}

TEST_CASE("refusals: fields of a wrong type or out of range, with their place and the range") {
    CHECK(refusal_of_fields(R"("amplitude_g": "strong")") ==
          "/patterns/0/amplitude_g: expected a number from 0 to 50, got \"strong\"\n");
    CHECK(refusal_of_fields(R"("amplitude_g": 50.1)") ==
          "/patterns/0/amplitude_g: expected a number from 0 to 50, got 50.1\n");
    CHECK(refusal_of_fields(R"("carriers": [{}, {"frequency_hz": -1}])") ==
          "/patterns/0/carriers/1/frequency_hz: expected a number from 0.1 to 1000, got -1\n");
    CHECK(refusal_of_fields(R"("carriers": [])") ==
          "/patterns/0/carriers: expected an array of 1 to 8, got an array of 0\n");
    CHECK(refusal_of_fields(R"("modulation": {"kind": "fm"})") ==
          "/patterns/0/modulation/kind: expected \"product\" or \"am\", got \"fm\"\n");
    CHECK(contains(refusal_of_fields(R"("rhythm": {"text": "x?-"})"),
                   "/patterns/0/rhythm/text: expected a rhythm"));
    CHECK(contains(refusal_of_fields(R"("duration_s": 0)"), "/patterns/0/duration_s: expected"));
    CHECK(contains(refusal_of_fields(R"("locked": 1)"), "expected true or false, got 1"));
    CHECK(contains(refusal_of_fields(R"("colour": "blue")"), "expected a colour as #RRGGBB"));
    CHECK(contains(refusal_of_fields(R"("note": [])"), "/patterns/0/note: expected a text"));
}

TEST_CASE("refusals: a result that cannot be written leaves the old file whole and nothing else") {
    const Folder folder;
    const std::string pair = folder.write("pair.json", kPair).string();
    CHECK(refusal_of({"predict", pair, "--out", "/dev/full"}) ==
          "tactspace: /dev/full: cannot be written: No space left on device\n");
    // Permissions do not bind root; these places bind everybody.
    for (const std::string& place : {std::string("/proc/matrix.csv"), pair + "/matrix.csv",
                                     folder.at("no folder/matrix.csv"), folder.path.string()}) {
        CHECK(contains(refusal_of({"predict", pair, "--out", place}),
                       "tactspace: " + place + ": cannot be written: "));
    }
    const std::string kept = folder.write("kept.csv", "precious").string();
    for (const std::string command : {"predict", "space"}) {
        const Ran ran = run_program({command, pair, "--out", kept}, "trap '' XFSZ; ulimit -f 0");
        CHECK(ran.exit_code == 1);
        CHECK(ran.out == "");
        CHECK(contains(ran.err, "tactspace: " + kept + ": cannot be written: File too large\n"));
        CHECK(bytes_of(kept) == "precious");
    }
    CHECK(file_count(folder.path) == 2);
}

// The system's signal for such a file would end the program with no word. The sanitizer of threads
// writes a file of its own before the program begins.
TEST_CASE("refusals: a limit on the size of files is an error like any other") {
#ifdef TACT_SANITIZES_THREADS
    const std::string limits = "trap '' XFSZ; ulimit -f 0";
#else
    const std::string limits = "ulimit -f 0";
#endif
    const Folder folder;
    const std::string pair = folder.write("pair.json", kPair).string();
    const std::string kept = folder.write("kept.csv", "precious").string();
    CHECK(contains(refusal_of({"predict", pair, "--out", kept}, limits),
                   "kept.csv: cannot be written: File too large\n"));
    CHECK(bytes_of(kept) == "precious");
    CHECK(file_count(folder.path) == 2);
}

TEST_CASE("refusals: pictures and folders that cannot be written") {
    const Folder folder;
    const std::string pair = folder.write("pair.json", kPair).string();
    const std::string under_file = pair + "/out";
    CHECK(contains(refusal_of({"snapshot", pair, "--out", "/dev/full"}),
                   "/dev/full: cannot be written: No space left on device"));
    CHECK(contains(refusal_of({"snapshot", pair, "--out", under_file}), "cannot be written"));
    CHECK(contains(refusal_of({"render", pair, "--out", under_file}), "cannot be made a folder"));
    CHECK(contains(refusal_of({"render", pair, "--out", pair}), "cannot be made a folder"));
    CHECK(contains(refusal_of({"stages", pair, "--pattern", "a", "--out", "/proc/new"}),
                   "/proc/new: cannot be made a folder"));
    CHECK(bytes_of(pair) == kPair);
}

TEST_CASE("refusals: a picture of no known kind or in no place, before any number is printed") {
    const Folder folder;
    const std::string pair = folder.write("pair.json", kPair).string();
    const std::string jpeg = folder.at("a.jpeg");
    const std::string lost = folder.at("no folder/a.svg");
    for (const std::string command : {"predict", "space"}) {
        CHECK(refusal_of({command, pair, "--image", jpeg}) ==
              "tactspace: " + jpeg + ": a picture's name ends in .png or .svg\n");
        CHECK(refusal_of({command, pair, "--image", lost}) ==
              "tactspace: " + lost + ": cannot be written: No such file or directory\n");
        CHECK(contains(refusal_of({command, pair, "--image", folder.path.string() + "/"}),
                       "cannot be written: Is a directory"));
    }
    CHECK(contains(refusal_of({"snapshot", pair, "--out", jpeg}), "ends in .png or .svg"));
    CHECK(contains(refusal_of({"snapshot", pair, "--out", lost}), "a.svg: cannot be written"));
    CHECK(file_count(folder.path) == 1);
}

TEST_CASE("refusals: options of predict that do not fit the metric") {
    const Folder folder;
    const std::string pair = folder.write("pair.json", kPair).string();
    CHECK(refusal_of({"predict", pair, "--metric", "st-sim", "--resume"}) ==
          "tactspace: --resume is for pm, nc and oc: nothing is kept of a run with --metric "
          "st-sim\n");
    for (const std::string metric : {"pm", "mtm"}) {
        CHECK(refusal_of({"predict", pair, "--metric", metric, "--first-as-reference"}) ==
              "tactspace: --first-as-reference is for st-sim and spqi: " + metric +
                  " is the same both ways\n");
    }
    CHECK(contains(refusal_of({"predict", pair, "--metric", "dtw", "--out", "/proc/new"}),
                   "/proc/new"));
}

TEST_CASE("refusals: choices of a snapshot that do not go together, before anything is made") {
    const Folder folder;
    const std::string pair = folder.write("pair.json", kPair).string();
    const auto refused = [&](std::vector<std::string> more, const std::string& out = "a.png") {
        more.insert(more.begin(), {"snapshot", pair, "--out", folder.at(out)});
        return refusal_of(more);
    };
    const std::vector<std::vector<std::string>> options{
        {"--at", "0"}, {"--with", "b"}, {"--stage", "brain"}, {"--tilted"}};
    for (const std::vector<std::string>& option : options) {
        for (const std::string view : {"space", "matrix", "wave", "spectrum"}) {
            std::vector<std::string> more{"--view", view};
            more.insert(more.end(), option.begin(), option.end());
            CHECK(contains(refused(more), option[0] + " needs --view physiology or window"));
        }
    }
    CHECK(contains(refused({"--view", "space", "--frames", "3"}, "f"), "needs a view that moves"));
    CHECK(contains(refused({"--view", "matrix", "--pattern", "a"}), "needs a view of one pattern"));
    CHECK(contains(refused({"--from", "0"}), "--from needs --frames"));
    CHECK(contains(refused({"--to", "1"}), "--to needs --frames"));
    CHECK(contains(refused({"--frames", "3", "--at", "0"}, "f"), "--at is for a single picture"));
    CHECK(contains(refused({"--frames", "3"}, "a.svg"), "this names a picture"));
    CHECK(contains(refused({"--view", "physiology", "--with", "a"}), "is the pattern itself"));
    CHECK(contains(refused({"--view", "physiology", "--with", "c"}), "expected one of a, b"));
    CHECK(contains(refused({"--view", "physiology", "--at", "99"}), "--at: expected a time from"));
    CHECK(contains(refused({"--frames", "3", "--to", "99"}, "f"), "--to: expected a time from 0"));
    CHECK(contains(refused({"--frames", "3", "--from", "0.01", "--to", "0.01"}, "f"),
                   "expected a time after --from 0.01 s"));
    CHECK(contains(refused({"--frames", "3"}, "pair.json"), "cannot be made a folder"));
    CHECK(file_count(folder.path) == 1);
    folder.write("f/frame_0004.png", "of a longer film");
    CHECK(contains(refused({"--frames", "3"}, "f"), "holds frame_0004.png of a longer sequence"));
    CHECK(file_count(folder.at("f")) == 1);
}

TEST_CASE("refusals: bad usage is exit code 2, says what is wrong and shows the way to help") {
    const Folder folder;
    const std::string pair = folder.write("pair.json", kPair).string();
    struct Usage {
        std::vector<std::string> arguments;
        std::string words;
    };
    const std::vector<Usage> all{
        {{"predict"}, "SET is required"},
        {{"predict", pair, "--metric", "taste"},
         "--metric: taste is no metric; expected one of pm, nc"},
        {{"predict", pair, "--metric", "vibromaf"}, "--metric: vibromaf is no distance: "},
        {{"predict", pair, "--loud"}, "--loud"},
        {{"predict", pair, "--threads", "-1"},
         "--threads: expected a number from 0 to 1024, got \"-1\""},
        {{"predict", pair, "--threads", "many"}, "--threads"},
        {{"space", pair, "--dim", "4"}, "--dim: expected a number from 2 to 3"},
        {{"stages", pair, "--out", folder.at("out")}, "--pattern is required"},
        {{"render", pair}, "--out is required"},
        {{"render", pair, "--format", "mp3", "--out", folder.at("out")}, "--format: mp3 not in"},
        {{"snapshot", pair, "--view", "inside", "--out", folder.at("a.png")}, "--view: inside"},
        {{"snapshot", pair, "--stage", "soul", "--out", folder.at("a.png")}, "--stage: soul"},
        {{"snapshot", pair, "--frames", "0", "--out", folder.at("f")},
         "--frames: expected a number from 1"},
        {{"snapshot", pair, "--width", "0", "--out", folder.at("a.png")},
         "--width: expected a number from 64"},
    };
    for (const auto& [arguments, words] : all) {
        CAPTURE(words);
        const Ran ran = run_program(arguments);
        CHECK(ran.exit_code == 2);
        CHECK(ran.out == "");
        CHECK_MESSAGE(contains(ran.err, words), ran.err);
        CHECK(contains(ran.err, "--help"));
    }
    CHECK(file_count(folder.path) == 1);
}

TEST_CASE("refusals: without a display the window says what works without one") {
    const Ran ran = run_program({});
    CHECK(ran.exit_code == 1);
    CHECK(ran.out == "");
    CHECK(contains(ran.err, "tactspace: no display"));
    CHECK(contains(ran.err, "tactspace predict SET"));
    CHECK(std::ranges::count(ran.err, '\n') == 1);
}

}  // namespace refusals_test
