// A hall of phones, by a bounded number of threads.
#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

#include "devices/device/crash_signals.h"
#include "devices/phone/phone_server.h"
#include "tests/support/comes_true.h"
#include "tests/support/many_sockets.h"
#include "tests/support/page_phone.h"

namespace phone_crowd_test {

using namespace tact;
using namespace tact::raw_phone;

namespace {

constexpr std::size_t kPhones = 400;
constexpr std::size_t kThreads = 8;

std::size_t thread_count() {
    const std::filesystem::directory_iterator tasks("/proc/self/task");
    return static_cast<std::size_t>(std::distance(begin(tasks), end(tasks)));
}

double resident_mb() {
    std::ifstream file("/proc/self/statm");
    double pages = 0.0;
    file >> pages >> pages;
    return pages * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

std::unique_ptr<PhoneServer> served(std::size_t most_phones = kPhones) {
    PhoneServerSettings settings;
    settings.host = "127.0.0.1";
    settings.most_phones = most_phones;
    settings.poll_s = 120.0;
    auto server = PhoneServer::open(std::move(settings));
    REQUIRE(server);
    return *std::move(server);
}

// `act` for each phone, by some threads.
template <class Act>
void each_of(std::vector<Phone>& phones, const Act& act) {
    std::vector<std::jthread> threads;
    for (std::size_t thread = 0; thread < kThreads; ++thread) {
        threads.emplace_back([&, thread] {
            for (std::size_t k = thread; k < phones.size(); k += kThreads) act(phones[k]);
        });
    }
}

// Every phone waits until `change` has happened; how many had news of it.
template <class Change>
std::size_t polled(std::vector<Phone>& phones, const Change& change) {
    std::vector<Connection> waiting;
    for (const Phone& phone : phones) {
        waiting.emplace_back(phone.place.port);
        waiting.back().send(phone.next_text());
    }
    change();
    std::size_t count = 0;
    for (std::size_t k = 0; k < phones.size(); ++k) {
        count += phones[k].news_of(waiting[k].reply()).empty() ? 0 : 1;
    }
    return count;
}

}  // namespace

TEST_CASE("phone crowd: 400 phones join, wait, play and answer, each for itself" *
          doctest::test_suite("long")) {
    allow_many_sockets();
    const std::size_t threads_before = thread_count();
    const double before_mb = resident_mb();
    std::atomic<int> failed = 0;
    {
        auto server = served();
        std::vector<Phone> phones(kPhones, Phone{Place(server->address())});
        each_of(phones, [&](Phone& phone) {
            if (phone.join("Kim").status != 200 || phone.next().empty()) ++failed;
        });
        CHECK(failed == 0);
        CHECK(server->phones().size() == kPhones);
        PhoneCards cards;
        for (const Phone& phone : phones) {
            cards.for_one[phone.number] = R"({"kind":"choice","id":"q)" +
                                          std::to_string(phone.number) +
                                          R"(","ask":"?","options":["a","b"]})";
        }
        double waiting_mb = 0.0;
        std::size_t waiting_threads = 0;
        const auto show = [&] {
            // What is measured is a full house; what is tested holds without.
            for (int k = 0; k < 2000 && thread_count() <= threads_before + kPhones; ++k) {
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            }
            waiting_mb = resident_mb();
            waiting_threads = thread_count();
            server->show(cards);
        };
        CHECK(polled(phones, show) == kPhones);
        MESSAGE("400 phones wait: " << waiting_mb - before_mb << " MB more, " << waiting_threads
                                    << " threads");
        CHECK(polled(phones, [&] { server->play({{20}, false, PhoneSide::both}); }) == kPhones);
        each_of(phones, [&](Phone& phone) {
            const std::string card = "q" + std::to_string(phone.number);
            if (phone.tell({{"card", card}, {"answer", {{"option", 1}}}}) != 204) ++failed;
            if (phone.tell({{"played", phone.play}}) != 204) ++failed;
        });
        CHECK(failed == 0);
        std::set<int> answered;
        for (const PhoneAnswer& answer : server->take_answers()) {
            CHECK(answer.card == "q" + std::to_string(answer.phone));
            answered.insert(answer.phone);
        }
        CHECK(answered.size() == kPhones);
        CHECK(asked(phones[0].place, "POST", "join", "{}").status == 503);
        for (const ConnectedPhone& phone : server->phones()) CHECK(phone.latency_s);
    }
    CHECK(comes_true([&] { return thread_count() <= threads_before; }));
}

TEST_CASE("phone crowd: memory and threads stay as they are, however often phones come" *
          doctest::test_suite("long")) {
    const std::size_t threads = thread_count() + 1;
    const auto server = served(20);
    const Place place(server->address());
    const auto rounds = [&](int count) {
        for (int k = 0; k < count; ++k) {
            Phone phone{place};
            const int status = phone.join("Kim").status;
            if (status != 200) continue;  // too many in this second
            phone.next();
            server->close_phone(phone.number);
        }
    };
    rounds(300);
    CHECK(comes_true([&] { return thread_count() <= threads; }));
    const double before_mb = resident_mb();
    rounds(1000);
    CHECK(comes_true([&] { return thread_count() <= threads; }));
    MESSAGE("1000 joins: " << resident_mb() - before_mb << " MB more");
    // A sanitizer keeps what was freed for a while.
    if (!kHasSanitizer) CHECK(resident_mb() - before_mb < 4.0);
    CHECK(server->phones().empty());
}

}  // namespace phone_crowd_test
