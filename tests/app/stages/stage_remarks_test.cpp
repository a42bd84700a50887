// Remarks on a stage name the patterns they are true of.
#include "app/stages/parts.h"

#include <doctest/doctest.h>

#include <atomic>

#include "model/physiology/firing.h"
#include "tests/support/physiology_program.h"
#include "viz/drawing/wave_body.h"
#include "viz/skin/fingertip.h"

namespace stage_remarks_test {

using namespace tact;

namespace {

LiveStages stages_of_tone(double frequency_hz, double amplitude_g) {
    PatternSet set = short_patterns(1);
    Pattern& pattern = std::get<Pattern>(set.vibrations[0].source);
    pattern.duration_s = set.duration_s = 1.0;
    pattern.amplitude_g = amplitude_g;
    pattern.carriers[0].frequency_hz = frequency_hz;
    std::atomic<float> progress = 0.0F;
    return *compute_live_stages(stages_request(set, 0), {}, progress);
}

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("remarks: the explanation of the waveform says which pauses are drawn filled") {
    const std::string widest = std::to_string(static_cast<int>(BodyScale().widest));
    CHECK(
        holds(text_of(Stage::brain).ours, "pauses of less than " + widest + " pixels are filled"));
}

TEST_CASE("remarks: Merkel cells follow what a filter leaks on 70 Hz, and a tone on 3 Hz") {
    const LiveStages high = stages_of_tone(70.0, 0.8);
    CHECK(high.only_leaks[index_of(Receptor::merkel)]);
    CHECK_FALSE(high.only_leaks[index_of(Receptor::meissner)]);
    CHECK(holds(stage_remark(high, Stage::filtered), "Merkel"));
    CHECK(holds(stage_remark(high, Stage::spikes), "leaks"));
    const LiveStages low = stages_of_tone(3.0, 0.8);
    CHECK_FALSE(low.only_leaks[index_of(Receptor::merkel)]);
}

TEST_CASE("remarks: the networks of a strong tone are gates, and it is said how much they are on") {
    const LiveStages live = stages_of_tone(70.0, 0.8);
    double at_cap = 0.0;
    for (const double count : live.central_count[index_of(Receptor::pacinian)]) {
        at_cap += count >= 50.0 ? 1.0 : 0.0;
    }
    at_cap /= static_cast<double>(live.central_count[index_of(Receptor::pacinian)].size());
    CHECK(at_cap > 0.9);
    CHECK(share_at_cap(live, Receptor::pacinian) == at_cap);
    CHECK(share_on(live, Receptor::pacinian) >= at_cap);
    CHECK(holds(stage_remark(live, Stage::networks), "Pacinian"));
    CHECK(holds(stage_remark(live, Stage::brain), "gates"));
}

TEST_CASE("remarks: what is fired after a pattern's end is told, and drawn paler step by step") {
    PatternSet set = short_patterns(1);
    Pattern& pattern = std::get<Pattern>(set.vibrations[0].source);
    pattern.duration_s = 0.5;
    pattern.amplitude_g = 0.8;
    pattern.carriers[0].frequency_hz = 150.0;
    pattern.modulation.frequency_hz = 0.0;
    set.vibrations.push_back(set.vibrations[0]);
    set.vibrations[1].name = "long";
    std::get<Pattern>(set.vibrations[1].source).duration_s = 1.0;
    std::atomic<float> progress = 0.0F;
    const LiveStages live = *compute_live_stages(stages_request(set, 0), {}, progress);
    std::int64_t in_silence = 0;
    for (const Receptor receptor : kReceptors) {
        const ChannelStages& channel = live.neural.channel[index_of(receptor)];
        const std::vector<char> silent = silent_steps(live.waveform, channel);
        std::int64_t behind = 0;
        for (const std::vector<int>& counts : channel.spike_count) {
            REQUIRE(silent.size() == counts.size());
            for (std::size_t step = 101; step < counts.size(); ++step) behind += counts[step];
        }
        for (std::size_t step = 0; step < silent.size(); ++step) {
            CHECK((silent[step] != 0) == (step >= 101));
        }
        CHECK(silent_firing(live.waveform, channel).in_silence == behind);
        in_silence += behind;
    }
    REQUIRE(in_silence > 0);
    CHECK(holds(stage_remark(live, Stage::spikes), "Paler: fired in silence"));
    CHECK(holds(stage_remark(live, Stage::central), "answers to filters that ring on"));
    const LiveStages steady = stages_of_tone(150.0, 0.8);
    CHECK_FALSE(holds(stage_remark(steady, Stage::spikes), "Paler"));
}

TEST_CASE("remarks: silence has none") {
    const LiveStages live = stages_of_tone(70.0, 0.0);
    for (const Stage stage : {Stage::filtered, Stage::receptors, Stage::spikes, Stage::networks,
                              Stage::brain, Stage::envelope}) {
        CHECK(stage_remark(live, stage).empty());
    }
}

TEST_CASE("fingertip: the probe is on it, a receptor 12 mm to the side is not") {
    CHECK(is_on_fingertip(0.0, 0.0));
    CHECK(is_on_fingertip(7.9, 0.0));
    CHECK(is_on_fingertip(0.0, -9.9));
    CHECK_FALSE(is_on_fingertip(12.0, 0.0));
    CHECK_FALSE(is_on_fingertip(0.0, 10.1));
    const LiveStages strong = stages_of_tone(70.0, 1.6);
    CHECK(beyond_finger(strong, Receptor::pacinian) > 0);
    CHECK(holds(stage_remark(strong, Stage::receptors), "Pacinian"));
    CHECK(beyond_finger(stages_of_tone(70.0, 0.05), Receptor::pacinian) == 0);
}

TEST_CASE("remarks: an opened stage shows its remark, and a pair names its rows") {
    PhysiologyProgram program;
    program.app.physiology.view.open = Stage::networks;
    program.settle();
    CHECK(holds(program.at("remark:networks").value, "cap"));
    program.app.physiology.view.open = Stage::brain;
    program.app.work.selection.pinned = "p2";
    program.wait_for_stages();
    CHECK(program.at("row a:brain").value == "p1");
    CHECK(program.at("row b:brain").value == "p2");
    CHECK(holds(program.at("row difference:brain").value, "difference, NC "));
}

TEST_CASE("remarks: what a filter leaks is said once, small in its trace and large above") {
    PatternSet set = short_patterns(2);
    for (Vibration& vibration : set.vibrations) {
        Pattern& pattern = std::get<Pattern>(vibration.source);
        pattern.duration_s = 1.0;
        pattern.amplitude_g = 0.8;
        pattern.carriers[0].frequency_hz = 70.0;
        pattern.modulation.frequency_hz = 0.0;
    }
    set.duration_s = 1.0;
    PhysiologyProgram program(set);
    CHECK(program.shows("leaks:SA1"));
    program.click("stage:filtered");
    CHECK(program.shows("remark:filtered"));
    CHECK_FALSE(program.shows("leaks:SA1"));
}

}  // namespace stage_remarks_test
