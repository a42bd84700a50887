// Every place that names firing types agrees: a type that only follows its filter's leak is never
// named as firing.
#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>

#include "app/document/editing.h"
#include "app/lesson/lesson.h"
#include "app/physiology/physiology.h"
#include "app/stages/parts.h"
#include "assets/assets.h"
#include "model/io/set/set_file.h"
#include "model/textbook/textbook_beside.h"

namespace firing_doors_test {

using namespace tact;

namespace {

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

std::vector<PatternSet> bundled() {
    std::vector<PatternSet> sets;
    for (const ExampleSet& example : kExampleSets) {
        const auto set = parse_set(asset(example.path), example.path, {});
        REQUIRE(set);
        if (set->vibrations.size() <= 20)
            sets.push_back(*set);  // the Morse signals have a single frequency
    }
    REQUIRE(sets.size() >= 9);
    return sets;
}

// Text that counts a type as firing, without a word about its filter.
bool counts_as_firing(const std::string& text, const std::string& name) {
    return holds(text, name + " fires") || holds(text, name + ": fires");
}

void check_remarks(const LiveStages& live, Receptor receptor) {
    const std::string name = traits(receptor).name;
    for (const bool has_textbook : {false, true}) {
        for (const Stage stage : {Stage::receptors, Stage::spikes}) {
            std::string remark = stage_remark(live, stage, has_textbook);
            // The remark "What Merkel fires here answers to what its filter leaks" is allowed.
            const std::size_t said = remark.find("What " + name + " fires here answers to what");
            if (said != std::string::npos) remark.erase(said, 5 + name.size() + 6);
            CHECK_FALSE(counts_as_firing(remark, name));
        }
    }
    CHECK(holds(short_remark(live, Stage::spikes), name + ": filter leak"));
    CHECK(holds(short_remark(live, Stage::receptors), name + ": filter leak"));
    CHECK(firing_note(live, receptor) == "filter leak");
}

void check_textbook(const LiveStages& live, Receptor receptor) {
    const BesideInput input{live.waveform, live.neural, live.request.model.coding.tables,
                            live.firing};
    for (const BesideFact& one : beside_the_model("spikes", input)) {
        CHECK(one.receptor != receptor);
    }
}

// A lesson that asks for the firing types and rates of every pattern of a set.
Lesson asking(const PatternSet& set) {
    Lesson lesson;
    lesson.name = "who fires";
    lesson.set = set;
    for (const Vibration& vibration : set.vibrations) {
        LessonStep step;
        step.pattern = vibration.name;
        step.text = "{felt | " + vibration.name + "}";
        step.question.emplace();
        step.question->kind = QuestionKind::receptors;
        step.question->ask = "Who fires?";
        lesson.steps.push_back(step);
    }
    return lesson;
}

}  // namespace

TEST_CASE("firing: no door names a type that only leaks as firing, in any bundled set" *
          doctest::test_suite("long")) {
    std::size_t leaking = 0;
    for (const PatternSet& set : bundled()) {
        CAPTURE(set.name);
        const Lesson lesson = asking(set);
        const LessonAnswers answers = lesson_answers(lesson, {}, false);
        for (std::size_t k = 0; k < set.vibrations.size(); ++k) {
            const std::string& pattern = set.vibrations[k].name;
            CAPTURE(pattern);
            std::atomic<float> progress = 0.0F;
            const auto live = compute_live_stages(stages_request(set, k), {}, progress);
            REQUIRE(live);
            const std::string& felt = answers.numbers.at("felt | " + pattern);
            const QuestionAnswer& answer = answers.questions[k];
            for (const Receptor receptor : kReceptors) {
                const std::string name = traits(receptor).name;
                CAPTURE(name);
                const Firing firing = live->firing[index_of(receptor)];
                CHECK(holds(felt, name) == (firing == Firing::fires));
                CHECK(std::ranges::count(answer.right, index_of(receptor)) ==
                      (firing == Firing::fires ? 1 : 0));
                if (firing != Firing::leaks) continue;
                ++leaking;
                const std::size_t at = answer.model.find(name + " ");
                REQUIRE(at != std::string::npos);
                CHECK(holds(answer.model.substr(at, 30), "(its filter leaks)"));
                check_remarks(*live, receptor);
                check_textbook(*live, receptor);
            }
            const bool ruffini = live->firing[index_of(Receptor::ruffini)] == Firing::fires;
            CHECK(holds(stage_remark(*live, Stage::spikes), "Par\u00e9") == ruffini);
            CHECK(holds(stage_remark(*live, Stage::receptors), "Par\u00e9") == ruffini);
            CHECK(holds(answer.model, "Par\u00e9") == ruffini);
        }
        const std::string html = lesson_sheet(LessonSheet{lesson, answers});
        for (const QuestionAnswer& answer : answers.questions) {
            if (holds(answer.model, "leaks")) CHECK(holds(html, "(its filter leaks)"));
        }
    }
    CHECK(leaking > 10);
}

TEST_CASE(
    "firing: a steady tone of 30 Hz leaves Merkel cells a leak, one of 3 Hz makes them fire") {
    for (const auto& [hz, firing] : {std::pair{30.0, Firing::leaks}, std::pair{40.0, Firing::leaks},
                                     std::pair{3.0, Firing::fires}}) {
        PatternSet set;
        Pattern pattern;
        pattern.amplitude_g = 0.8;
        pattern.carriers[0].frequency_hz = hz;
        Vibration vibration;
        vibration.name = "tone";
        vibration.source = pattern;
        set.vibrations = {vibration};
        std::atomic<float> progress = 0.0F;
        const auto live = compute_live_stages(stages_request(set, 0), {}, progress);
        REQUIRE(live);
        CAPTURE(hz);
        CHECK(live->firing[index_of(Receptor::merkel)] == firing);
        if (hz < 30.0) continue;
        // Both stages, large and small, mention more than one impulse a cycle.
        for (const Stage stage : {Stage::receptors, Stage::spikes}) {
            CHECK(holds(stage_remark(*live, stage), "Impulses a cycle: Meissner"));
            CHECK(holds(short_remark(*live, stage), "a cycle"));
        }
        CHECK(holds(firing_note(*live, Receptor::meissner), "a cycle"));
    }
}

}  // namespace firing_doors_test
