// The window while a hall of phones rates together: no frame is kept waiting by them.
#define DOCTEST_CONFIG_DISABLE

#include <algorithm>
#include <atomic>
#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>
#include <vector>

#include "app/phones/phones.h"
#include "model/common/distributions.h"
#include "tests/bench/owed.h"
#include "tests/support/many_sockets.h"
#include "tests/support/page_phone.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

using namespace tact;
using namespace tact::bench;

namespace {

using raw_phone::Phone;

constexpr std::size_t kHall = 400;
constexpr std::size_t kFingers = 4;  // threads that act for all of them
// All of them together answer this often: each once in four seconds.
constexpr auto kBetweenAnswers = std::chrono::milliseconds(40);

void rate_on(std::vector<Phone>& phones, std::size_t finger, const std::atomic<bool>& ends,
             std::atomic<int>& taken) {
    for (std::size_t round = 0; !ends; ++round) {
        for (std::size_t k = finger; k < phones.size() && !ends; k += kFingers) {
            const nlohmann::json answer{{"k", round},
                                        {"similarity", 40},
                                        {"plays", {1, 1}},
                                        {"first", "left"},
                                        {"response_ms", 4000}};
            taken += phones[k].tell({{"card", "rating 1"}, {"answer", answer}}) == 204 ? 1 : 0;
            std::this_thread::sleep_for(kBetweenAnswers);
        }
    }
}

void frame_with_phones(benchmark::State& state) {
    allow_many_sockets();
    const TemporaryFolder folder;
    Program program(short_patterns(10));
    App& app = program.app;
    app.phones.host = "127.0.0.1";
    serve_phones(app.ui, app.play, app.phones);
    std::vector<Phone> phones(kHall, Phone{raw_phone::Place(app.phones.server->address())});
    for (Phone& phone : phones) {
        phone.join("Kim");
        program.frame();
    }
    app.work.document.edit().study.repetitions = 1;
    begin_rating(app.ui, app.work, app.phones, folder.path / "class");
    for (int k = 0; k < 20; ++k) program.frame();
    app.ui.rects.file.clear();
    std::atomic<bool> ends = false;
    std::atomic<int> taken = 0;
    std::vector<std::jthread> fingers;
    for (std::size_t finger = 0; finger < kFingers; ++finger) {
        fingers.emplace_back([&, finger] { rate_on(phones, finger, ends, taken); });
    }
    std::vector<double> frames_s;
    for (auto _ : state) {
        const double begin_s = clock_s();
        program.frame();
        frames_s.push_back(clock_s() - begin_s);
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    ends = true;
    fingers.clear();
    state.counters["answers"] = static_cast<double>(taken.load());
    state.counters["kept"] = static_cast<double>(progress_of(*app.phones.rating).answers);
    state.counters["median_ms"] = 1e3 * quantile(frames_s, 0.5);
    owe_at_most(state, 1e3 * *std::ranges::max_element(frames_s), 33.0, "ms (longest)");
    end_phones(app.phones);
}

}  // namespace

BENCHMARK(frame_with_phones)->Name("interface/frame_with_400_phones")->Iterations(600);
