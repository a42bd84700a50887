#include "model/io/people/study_file.h"

#include <doctest/doctest.h>
#include <sys/stat.h>

#include <cmath>
#include <fstream>

#include "model/common/random.h"
#include "model/io/people/study_lines.h"
#include "tests/support/mutations.h"
#include "tests/support/no_more_than.h"
#include "tests/support/temporary_folder.h"

namespace study_file_test {

using namespace tact;

namespace {

StudyHeader header() {
    StudyHeader header;
    header.program = "tactspace 9.9";
    header.set_name = "three";
    header.set_fingerprint = "0123456789abcdef";
    header.patterns = {"low", "mid, loud", "h\u00f6h \"x\""};
    header.design.repetitions = 2;
    header.design.consent = "I agree.";
    header.seed = 0xfedcba9876543210U;
    header.device = {"memory", "uncalibrated", "pink noise at 0.3 on ears"};
    header.participant = {"P1", {{"age", "27"}, {"hand", "left"}}};
    header.consented = true;
    header.begun = "2026-01-02T03:04:05Z";
    return header;
}

const PairAnswer kAnswer{{0, 2}, 54.0, 1, 3, 6.25, "2026-01-02T03:05:00Z"};
const PairAnswer kOther{{1, 1}, 99.0, 2, 1, 3.5, "2026-01-02T03:06:00Z"};

StudyLog begun(const std::filesystem::path& path) {
    auto log = StudyLog::begin(path, header());
    REQUIRE_MESSAGE(log, (log ? "" : log.error().message));
    return *std::move(log);
}

std::string fault_of(const std::string& text) {
    const auto record = parse_study(text, "P1.jsonl");
    REQUIRE_FALSE(record);
    return record.error().message;
}

}  // namespace

TEST_CASE("study file: what is written is read back, line by line") {
    const TemporaryFolder folder;
    const auto path = folder.path / "P1.jsonl";
    {
        StudyLog log = begun(path);
        CHECK(read_study_file(path)->header == header());
        REQUIRE(log.append(answer_line(header(), 0, kAnswer)));
        CHECK(read_study_file(path)->answers == std::vector{kAnswer});
        REQUIRE(log.append(answer_line(header(), 1, kOther)));
    }
    const auto record = read_study_file(path);
    REQUIRE(record);
    CHECK(*record == StudyRecord{header(), {kAnswer, kOther}, {}, false});
}

namespace {

std::string any_text(RandomStream& random) {
    constexpr const char* kTexts[] = {"", "P1", "a, b", "h\u00f6h \"x\"\n", "{}", " ", "\t\\"};
    return kTexts[next_index(random, std::size(kTexts))];
}

PlaysReport any_report(RandomStream& random) {
    if (next_index(random, 2) == 0) return {};
    return {static_cast<int>(next_index(random, 3)), static_cast<int>(next_index(random, 9)),
            std::abs(next_even(random)) * 40.0};
}

StudyRecord any_record(std::uint64_t seed) {
    RandomStream random{random_bits(77, seed)};
    StudyRecord record;
    record.header = header();
    record.header.kind = seed % 2 == 0 ? StudyKind::pairwise : StudyKind::sorting;
    record.header.synthetic = next_index(random, 2) == 1;
    record.header.device = {any_text(random), any_text(random), any_text(random),
                            100.0 * static_cast<double>(seed % 3)};
    record.header.seed = random_bits(78, seed);
    record.header.participant = {any_text(random), {{"age", any_text(random)}}};
    const std::size_t n = record.header.patterns.size();
    for (std::size_t k = next_index(random, 6); k > 0; --k) {
        if (record.header.kind == StudyKind::pairwise) {
            record.answers.push_back({{next_index(random, n), next_index(random, n)},
                                      50.0 + 50.0 * next_even(random),
                                      static_cast<int>(next_index(random, 3)),
                                      static_cast<int>(next_index(random, 3)),
                                      std::abs(next_even(random)),
                                      any_text(random),
                                      any_report(random),
                                      any_report(random)});
        } else {
            // Groups are numbered as they come.
            Sorting groups(n, kUnsorted);
            groups[next_index(random, n)] = 0;
            record.sortings.push_back({static_cast<int>(next_index(random, 4)), groups,
                                       std::abs(next_even(random)), any_text(random)});
        }
        if (next_index(random, 3) == 0) {
            record.devices.push_back({answers_given(record),
                                      {any_text(random), any_text(random), any_text(random),
                                       static_cast<double>(seed % 4)},
                                      any_text(random)});
        }
    }
    return record;
}

}  // namespace

TEST_CASE("study file: every record is written and read back as it was, devices in their places") {
    const TemporaryFolder folder;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        CAPTURE(seed);
        const StudyRecord record = any_record(seed);
        const std::string text = print_study(record);
        const auto read = parse_study(text, "P1.jsonl");
        REQUIRE_MESSAGE(read, (read ? "" : read.error().message));
        CHECK(*read == record);
        CHECK(print_study(*read) == text);
        if (seed > 5) continue;
        const auto path = folder.path / (std::to_string(seed) + ".jsonl");
        REQUIRE(write_study_file(path, record));
        CHECK(bytes_of(path) == text);
        CHECK_FALSE(write_study_file(path, record));
    }
}

TEST_CASE("study file: whatever a reader accepts is written and read back as the same") {
    const std::string head = header_line(header());
    StudyHeader sorting = header();
    sorting.kind = StudyKind::sorting;
    const std::string sorted = header_line(sorting);
    std::size_t accepted = 0;
    for (const std::string& text : {
             head + "\n{\"left\":\"low\",\"right\":\"low\",\"rating\":-0.0}",
             "\n \n" + head + "\n\n{\"device\":{}}\n{\"device\":{\"name\":\"x\"},\"at\":\"t\"}\n",
             sorted + "\n{\"groups\":[]}\n",
             sorted + "\n{}\n",
             sorted + "\n{\"groups\":[[],[]]}\n",
             sorted + "\n{\"groups\":[[],[\"low\"],[],[\"mid, loud\"]]}\n",
             sorted + "\n{\"groups\":[[\"low\"],[\"low\"]]}\n",
             std::string(R"({"tactspace_study":1,"patterns":["a","a"]})"),
             std::string(
                 R"({"tactspace_study":1,"patterns":["a","b"],"seed":"99999999999999999999"})"),
             std::string(R"({"tactspace_study":1,"patterns":["a","b"],"consent":{"text":"yes"}})"),
             std::string(" \n\n"),
         }) {
        CAPTURE(text);
        const auto read = parse_study(text, "P1.jsonl");
        if (!read) continue;
        ++accepted;
        const auto again = parse_study(print_study(*read), "P1.jsonl");
        REQUIRE_MESSAGE(again, (again ? "" : again.error().message));
        CHECK(*again == *read);
    }
    CHECK(accepted == 4);
    CHECK(contains(fault_of(sorted + "\n{}\n"), "/groups: expected groups of patterns"));
    CHECK(contains(fault_of(R"({"tactspace_study":1,"patterns":["a","a"]})"), "names that differ"));
}

TEST_CASE("study file: after an accident it is refused by its line, or kept as it was read") {
    std::size_t accepted[2] = {0, 0};
    for (unsigned seed = 0; seed < 1500; ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        const std::string text = after_mishaps(print_study(any_record(seed)), random);
        const auto read = parse_study(text, "P1.jsonl");
        if (!read) {
            CHECK(contains(read.error().message, "P1.jsonl"));
            CHECK_FALSE(contains(read.error().message, "\n"));
            continue;
        }
        ++accepted[read->header.kind == StudyKind::sorting ? 1 : 0];
        const auto again = parse_study(print_study(*read), "again.jsonl");
        REQUIRE_MESSAGE(again, (again ? "" : again.error().message));
        StudyRecord whole = *read;
        whole.is_torn = false;  // what was torn off is gone
        CHECK(*again == whole);
    }
    CHECK(accepted[0] > 20);
    CHECK(accepted[1] > 20);
}

TEST_CASE("study file: an answer that a copy has doubled is refused by both of its lines") {
    StudyHeader sorting = header();
    sorting.kind = StudyKind::sorting;
    const std::string rated = answer_line(header(), 0, kAnswer) + "\n";
    const std::string next = answer_line(header(), 1, kAnswer) + "\n";
    const std::string sorted =
        answer_line(sorting, 0, SortingAnswer{2, {0, 1, 0}, 3.0, "t"}) + "\n";
    for (const std::string& twice : {header_line(header()) + "\n" + rated + next + rated,
                                     header_line(sorting) + "\n" + sorted + "\n\n" + sorted,
                                     header_line(header()) + "\n" + rated + "\n\n " + rated}) {
        CAPTURE(twice);
        CHECK(contains(fault_of(twice), "P1.jsonl:"));
        CHECK(contains(fault_of(twice), "expected each answer once, got that of line 2 again"));
    }
    CHECK(contains(fault_of(header_line(header()) + "\n" + rated + next + rated), "P1.jsonl:4: "));
    // The same pair once more, and answers by hand that have no numbers, are answers of their own.
    const std::string by_hand = "{\"left\":\"low\",\"right\":\"low\",\"rating\":5}\n";
    CHECK(parse_study(header_line(header()) + "\n" + rated + next, "P1.jsonl"));
    CHECK(parse_study(header_line(header()) + "\n" + by_hand + by_hand, "P1.jsonl"));
}

TEST_CASE("study file: torn anywhere in its last line, it loses that line alone and goes on") {
    const TemporaryFolder folder;
    const auto whole = folder.path / "P1.jsonl";
    {
        StudyLog log = begun(whole);
        REQUIRE(log.append(answer_line(header(), 0, kAnswer)));
        REQUIRE(log.append(answer_line(header(), 1, kOther)));
    }
    const std::string bytes = bytes_of(whole);
    const std::size_t second = bytes.rfind('\n', bytes.size() - 2) + 1;
    for (std::size_t cut = second; cut <= bytes.size(); ++cut) {
        CAPTURE(cut - second);
        const auto path = folder.write("torn.jsonl", bytes.substr(0, cut));
        const auto record = read_study_file(path);
        REQUIRE(record);
        const bool all = cut + 1 >= bytes.size();  // but the end of the line
        CHECK(record->answers.size() == (all ? 2 : 1));
        {
            auto log = StudyLog::resume(path, *record);
            REQUIRE(log);
            REQUIRE(log->append(answer_line(header(), record->answers.size(), kOther)));
        }
        const auto after = read_study_file(path);
        REQUIRE(after);
        CHECK_FALSE(after->is_torn);
        CHECK(after->answers.size() == (all ? 3 : 2));
        CHECK(after->answers.back() == kOther);
    }
}

TEST_CASE("study file: what the disk has no room for is refused, and the file ends where it did") {
    const TemporaryFolder folder;
    const auto path = folder.path / "P1.jsonl";
    {
        StudyLog log = begun(path);
        REQUIRE(log.append(answer_line(header(), 0, kAnswer)));
        const std::string before = bytes_of(path);
        for (const std::size_t room : {0U, 1U, 20U}) {
            const NoMoreThan full(before.size() + room);
            const auto refused = log.append(answer_line(header(), 1, kOther));
            REQUIRE_FALSE(refused);
            CHECK(contains(refused.error().message, "P1.jsonl: cannot be written: "));
            CHECK(bytes_of(path) == before);
        }
        REQUIRE(log.append(answer_line(header(), 1, kOther)));
    }
    CHECK(*read_study_file(path) == StudyRecord{header(), {kAnswer, kOther}, {}, false});
    // Nothing is left of a participant who could not be begun.
    const NoMoreThan full(20);
    CHECK_FALSE(StudyLog::begin(folder.path / "P2.jsonl", header()));
    CHECK_FALSE(std::filesystem::exists(folder.path / "P2.jsonl"));
}

TEST_CASE("study file: nobody's file is written over, or by two at once") {
    const TemporaryFolder folder;
    const auto path = folder.path / "P1.jsonl";
    const StudyLog log = begun(path);
    const std::string before = bytes_of(path);
    const auto again = StudyLog::begin(path, header());
    REQUIRE_FALSE(again);
    CHECK(contains(again.error().message, "expected another code for participant \"P1\""));
    CHECK(bytes_of(path) == before);
    const auto pipe = folder.path / "pipe.jsonl";
    REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
    CHECK(contains(StudyLog::resume(pipe, {}).error().message, "is a pipe, expected a file"));
    const auto second = StudyLog::resume(path, *read_study_file(path));
    REQUIRE_FALSE(second);
    CHECK(contains(second.error().message, "another tactspace is writing it"));
    CHECK_FALSE(StudyLog::begin(folder.path / "no" / "such.jsonl", header()));
}

TEST_CASE("study file: it goes on only where it was left") {
    const TemporaryFolder folder;
    const auto path = folder.path / "P1.jsonl";
    { StudyLog log = begun(path); }
    StudyRecord other = *read_study_file(path);
    other.answers.push_back(kAnswer);
    REQUIRE_FALSE(StudyLog::resume(path, other));
    other = *read_study_file(path);
    other.header.participant.code = "P2";
    REQUIRE_FALSE(StudyLog::resume(path, other));
}

TEST_CASE("study file: sorting rounds are read back, whatever was left out") {
    StudyHeader head = header();
    head.kind = StudyKind::sorting;
    const SortingAnswer answer{2, {0, kUnsorted, 1}, 41.0, "2026-01-02T03:05:00Z"};
    const std::string text = header_line(head) + "\n" + answer_line(head, 0, answer) + "\n";
    const auto record = parse_study(text, "P1.jsonl");
    REQUIRE(record);
    CHECK(record->sortings == std::vector{answer});
}

TEST_CASE("study file: a wrong line is named") {
    const std::string head = header_line(header()) + "\n";
    const std::string line = answer_line(header(), 0, kAnswer);
    CHECK(fault_of("") == "P1.jsonl: is empty, expected the study of a participant");
    CHECK(contains(fault_of("{\"a\":1}\n"), "P1.jsonl:1"));
    CHECK(contains(fault_of(head + "{torn\n" + line + "\n"), "P1.jsonl:2"));
    std::string odd = line;
    odd.replace(odd.find("\"low\""), 5, "\"who\"");
    CHECK(
        contains(fault_of(head + odd + "\n"), "P1.jsonl:2: /left: expected the name of a pattern"));
    odd = line;
    odd.replace(odd.find("54"), 2, "154");
    CHECK(contains(fault_of(head + odd + "\n"), "/rating"));
    CHECK(contains(fault_of(head + "{\"left\":\"low\",\"right\":\"low\"}\n"), "/rating"));
}

TEST_CASE("study file: codes become names of files that cannot leave their folder") {
    CHECK(study_file_name("P1") == "P1.jsonl");
    CHECK(study_file_name("../a b") == "___a_b.jsonl");
    CHECK(study_file_name("...") == "");
}

TEST_CASE("study file: plays of the training that were cut short stand with the first answer") {
    StudyRecord record{header(), {kAnswer, kOther}, {}, false};
    CHECK_FALSE(contains(print_study(record), "broken_in_training"));
    record.answers[0].broken_in_training = 3;
    record.header.versions = {"1", "2", "3"};
    const std::string text = print_study(record);
    CHECK(contains(text, "\"broken_in_training\":3"));
    CHECK(*parse_study(text, "P1.jsonl") == record);
}

TEST_CASE("study file: a folder tells by first lines what is asked otherwise than at first") {
    const TemporaryFolder folder;
    StudyHeader now = header();
    CHECK(changes_on_disk(folder.path / "nowhere", now).empty());
    CHECK(changes_on_disk(folder.path, now).empty());
    begun(folder.path / "P1.jsonl");
    folder.write("P2.jsonl", "{\"tactspace_study\": 1, \"part");  // torn
    now.participant.code = "P3";
    CHECK(changes_on_disk(folder.path, now).empty());
    now.design.repetitions = 3;
    CHECK(words_on_changes(changes_on_disk(folder.path, now)) == "repetitions 3, not 2");
    now.kind = StudyKind::sorting;  // of which nobody has fixed anything
    CHECK(changes_on_disk(folder.path, now).empty());
}

TEST_CASE("study file: a folder gives its participants in natural order") {
    const TemporaryFolder folder;
    CHECK_FALSE(read_study_folder(folder.path));
    CHECK_FALSE(read_study_folder(folder.path / "none"));
    for (const char* code : {"P10", "P2"}) {
        StudyHeader head = header();
        head.participant.code = code;
        folder.write(study_file_name(code), header_line(head) + "\n");
    }
    folder.write("notes.txt", "not a study");
    const auto records = read_study_folder(folder.path);
    REQUIRE(records);
    REQUIRE(records->size() == 2);
    CHECK((*records)[0].header.participant.code == "P2");
}

}  // namespace study_file_test
