// The dialog on phones in the program's real frames, with phones that join over a real socket.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>

#include "app/phones/phones.h"
#include "app/play/play.h"
#include "app/study/study.h"
#include "devices/phone/phone_desk.h"
#include "devices/phone/phone_device.h"
#include "tests/support/page_phone.h"
#include "tests/support/program.h"
#include "tests/support/scene_steps.h"
#include "tests/support/temporary_folder.h"

namespace phones_dialog_test {

using namespace tact;
using namespace tact::raw_phone;
using nlohmann::json;

namespace {

// The page served, and nobody there.
struct Served {
    TemporaryFolder folder;
    Program program;

    explicit Served(std::size_t patterns = 4) : program(short_patterns(patterns)) {
        program.app.work.session.folder = folder.path;
        program.app.phones.host = "127.0.0.1";
        run(program, "Phones...");
        program.click("button:serve phones");
        wait_until(program, [this] { return program.shows("phones:address"); });
    }
    ~Served() { end_phones(program.app.phones); }

    std::string address() const { return program.at("phones:address").value; }

    Phone joined(const std::string& nickname, bool vibrates = true) {
        Phone phone{raw_phone::Place(address())};
        REQUIRE(phone.join(nickname, vibrates).status == 200);
        wait_until(program, [&] { return program.shows("phone:" + std::to_string(phone.number)); });
        return phone;
    }

    // The card of which that holds, once the phone has it. A page asks less often than frames pass.
    json card_that(Phone& phone, const std::function<bool(const json&)>& holds) {
        json found;
        auto next = std::chrono::steady_clock::now();
        wait_until(program, [&] {
            if (std::chrono::steady_clock::now() < next) return false;
            next = std::chrono::steady_clock::now() + std::chrono::milliseconds(60);
            Phone fresh = phone;
            fresh.card = fresh.play = 0;
            const json news = fresh.next();
            if (news.is_null()) return false;
            found = news.at("card");
            return holds(found);
        });
        return found;
    }
    json card(Phone& phone, const std::string& kind) {
        return card_that(phone, [&](const json& found) { return found.at("kind") == kind; });
    }

    // Sent again while the phone is told that it answers too often.
    int tell(const Phone& phone, const json& what) {
        int status = 0;
        wait_until(program, [&] { return (status = phone.tell(what)) != kTooManyRequests; });
        return status;
    }
};

json rating(std::size_t k, double similarity) {
    return {{"k", k},
            {"similarity", similarity},
            {"plays", {1, 1}},
            {"first", "left"},
            {"response_ms", 900}};
}

}  // namespace

TEST_CASE("phones: nothing listens until it is asked for, nor after" *
          doctest::test_suite("long")) {
    Program program(short_patterns(3));
    CHECK_FALSE(are_phones_served(program.app.phones));
    Served served;
    const raw_phone::Place place(served.address());
    CHECK(asked(place, "GET", "").status == 200);
    served.program.click("link:stop phones");
    CHECK(asked(place, "GET", "").status == 0);
    CHECK(served.program.shows("button:serve phones"));
}

TEST_CASE("phones: a phone gets the patterns to feel, and those of the next edit" *
          doctest::test_suite("long")) {
    Served served;
    Phone kim = served.joined("Kim");
    const json card = served.card(kim, "feel");
    REQUIRE(card.at("patterns").size() == 4);
    CHECK(card.at("patterns").at(0).at("name") == "p1");
    CHECK_FALSE(card.at("patterns").at(0).at("ms").empty());
    CHECK(served.program.at("phones:here").value == "1 phone");
    served.program.app.work.document.edit().vibrations.pop_back();
    document_changed(served.program.app.work);
    commit_step(served.program.app.ui, served.program.app.work, "one less");
    wait_until(served.program, [&] { return served.card(kim, "feel").at("patterns").size() == 3; });
}

TEST_CASE("phones: play in the window plays on them, and Esc stops it" *
          doctest::test_suite("long")) {
    Served served;
    Phone kim = served.joined("Kim");
    served.card(kim, "feel");
    kim.next();
    served.program.click("button:play on phones");
    served.program.press_key(key::kEscape);
    wait_until(served.program, [&] { return can_sound(served.program.app.play); });
    served.program.press(U' ');
    const json play = kim.next().at("play");
    CHECK_FALSE(play.at("ms").empty());
    served.program.press_key(key::kEscape);
    const json stopped = kim.next().at("play");
    CHECK((stopped.at("ms").empty() || stopped.at("stop") == true));
}

TEST_CASE("phones: rated together, the answers are a study of the window" *
          doctest::test_suite("long")) {
    Served served(3);
    std::vector<Phone> phones{served.joined("Kim"), served.joined("Lee")};
    served.program.click("button:rate together");
    CHECK(served.program.app.work.document.set.study.repetitions == 1);
    CHECK(served.program.shows("phones:rating"));
    for (Phone& phone : phones) {
        const json card = served.card(phone, "rating");
        for (std::size_t k = 0; k < card.at("trials").size(); ++k) {
            const json& trial = card.at("trials")[k];
            const double alike = trial[0] == trial[1] ? 100.0 : 30.0;
            CHECK(served.tell(phone, {{"card", card.at("id")}, {"answer", rating(k, alike)}}) ==
                  204);
        }
        served.card(phone, "thanks");
    }
    CHECK(served.program.at("phones:rating").value.find("2 to the end") != std::string::npos);
    const auto records =
        read_study_folder(study_folder(served.program.app.work, served.program.app.studying));
    REQUIRE(records);
    CHECK(records->size() == 2);
    served.program.click("button:show rating");
    wait_for_answers(served.program);
    REQUIRE(served.program.app.studying.answers->results);
    CHECK(served.program.app.studying.answers->results->people.size() == 2);
    CHECK_FALSE(served.program.app.studying.answers->is_of_other_patterns);
}

TEST_CASE("phones: twenty trials on one of them are kept with the set, in one step" *
          doctest::test_suite("long")) {
    Served served;
    begin_jobs(served.program.app);
    request_maps(served.program.app.ui, served.program.app.work, served.program.app.shown_map,
                 served.program.app.rendered);
    Phone kim = served.joined("Kim");
    Phone lee = served.joined("Lee", false);
    served.card(kim, "feel");
    served.program.wait_for_exact_map();
    served.program.click("phone " + std::to_string(kim.number) + " trials");
    for (int k = 0; k < kUsualTrials; ++k) {
        const json card = served.card_that(kim, [k](const json& found) {
            return found.at("kind") == "trial" && found.at("at") == k + 1;
        });
        const json answer{{"option", 1}, {"plays", {1, 1, 1}}, {"response_ms", 700}};
        CHECK(served.tell(kim, {{"card", card.at("id")}, {"answer", answer}}) == 204);
    }
    served.card(kim, "thanks");
    const Workspace& work = served.program.app.work;
    REQUIRE(work.document.set.told_apart.size() == 1);
    CHECK(work.document.set.told_apart[0].answers.size() == kUsualTrials);
    CHECK(work.document.set.told_apart[0].person == "Kim");
    served.program.press_key(key::kEscape);
    served.program.settle();
    CHECK(served.program.shows("map:told apart"));
    served.program.press(U'z', true);
    CHECK(work.document.set.told_apart.empty());
}

TEST_CASE("phones: another document ends what was under way on the patterns of the first" *
          doctest::test_suite("long")) {
    Served served(3);
    Phone kim = served.joined("Kim");
    served.program.click("button:rate together");
    served.card(kim, "rating");
    served.program.app.work.document.open({short_patterns(5), {}, short_patterns(5)});
    ++served.program.app.work.document_number;
    ++served.program.app.work.revision;
    served.program.settle();
    CHECK_FALSE(served.program.app.phones.rating);
    served.card_that(kim, [](const json& found) {
        return found.at("kind") == "feel" && found.at("patterns").size() == 5;
    });
}

}  // namespace phones_dialog_test
