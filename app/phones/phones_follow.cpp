#include "app/phones/phones.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "app/document/editing.h"
#include "app/play/play.h"
#include "devices/phone/phone_device.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

// An answer is on the disk before it counts: what comes in faster waits for the next frame.
constexpr auto kAnswersLast = std::chrono::milliseconds(6);
constexpr std::size_t kMostFelt =
    100;  // patterns of a list to tap: as many as a thumb looks through

PhonePatternsRequest request_of(const Workspace& work) {
    return {work.document_number, work.revision, work.document.committed};
}

std::optional<MadePhonePatterns> made_patterns(const PhonePatternsRequest& request,
                                               const std::stop_token& stop,
                                               std::atomic<float>& /*progress*/) {
    auto made = phone_patterns(*request.set, stop);
    if (!made) return std::nullopt;
    return MadePhonePatterns{request, std::move(made->patterns), made->full_scale_g};
}

void follow_patterns(Ui& ui, const Workspace& work, PlayState& play, PhonesState& state) {
    state.patterns_job.want(request_of(work), made_patterns, ui.wake);
    const auto made = state.patterns_job.latest();
    if (!made || made == state.cards_of) return;
    state.cards_of = made;
    state.cards_due = true;
    play.phone_full_scale_g = made->full_scale_g;
}

// What is under way is about the patterns of its own document.
void follow_document(Ui& ui, const Workspace& work, PhonesState& state) {
    if (state.trials && state.trials_document != work.document_number) end_trials(ui, state);
    if (state.rating && state.rating_document != work.document_number) end_rating(ui, state);
}

bool is_question(const PhonesState& state, const PhoneAnswer& answer) {
    return state.question && answer.card == state.question->id;
}

void take_choice(PhonesState& state, const PhoneAnswer& answer) {
    if (state.question->revealed) return;
    const auto option = option_answered(answer.json, state.question->options.size());
    if (!option) return;
    state.said[answer.card][answer.phone] = *option;
    state.cards_due = true;
}

// True: it is kept.
bool take_rated(Ui& ui, PhonesState& state, const PhoneAnswer& answer) {
    ClassRating& rating = *state.rating;
    const bool is_kept = take_rating(rating, *state.server, answer).is_kept;
    if (!rating.fault.empty()) complain(ui, "An answer could not be kept: " + rating.fault);
    return is_kept;
}

bool take_answer(Ui& ui, PhonesState& state, const PhoneAnswer& answer) {
    if (is_question(state, answer)) {
        take_choice(state, answer);
        return false;
    }
    if (state.trials && answer.phone == state.trials->phone) {
        state.cards_due |= take_trial(state.trials->trials, answer.card, answer.json);
        return false;
    }
    if (state.rating && answer.card == state.rating->id) return take_rated(ui, state, answer);
    return false;
}

std::string card_for_all(const PhonesState& state) {
    if (!state.cards_of || state.cards_of->patterns.empty()) return wait_card();
    const std::span<const PhonePattern> all = state.cards_of->patterns;
    return feel_card(all.first(std::min(all.size(), kMostFelt)));
}

void add_questions(const PhonesState& state, PhoneCards& cards) {
    cards.for_all = card_of(*state.question);
    const auto said = state.said.find(state.question->id);
    if (said == state.said.end()) return;
    for (const auto& [phone, option] : said->second) {
        ChoiceCard own = *state.question;
        own.mine = option;
        cards.for_one[phone] = card_of(own);
    }
}

PhoneCards cards_of(PhonesState& state) {
    PhoneCards cards{card_for_all(state), {}};
    if (state.question) {
        add_questions(state, cards);
        return cards;
    }
    if (state.rating) {
        for (const ConnectedPhone& phone : state.phones) {
            cards.for_one[phone.number] = card_of(*state.rating, phone.number, phone.nickname);
        }
    }
    if (state.trials) cards.for_one[state.trials->phone] = card_of(state.trials->trials);
    for (const int phone : state.tried) cards.for_one.try_emplace(phone, thanks_card({}));
    return cards;
}

// A phone that has just come gets its card, too.
bool has_new_phone(const std::vector<ConnectedPhone>& before,
                   const std::vector<ConnectedPhone>& now) {
    return std::ranges::any_of(now, [&](const ConnectedPhone& phone) {
        return std::ranges::find(before, phone.number, &ConnectedPhone::number) == before.end();
    });
}

void count_votes(PhonesState& state) {
    if (!state.question) return;
    state.question->votes.assign(state.question->options.size(), 0);
    for (const auto& [phone, option] : state.said[state.question->id]) {
        if (option < state.question->votes.size()) ++state.question->votes[option];
    }
}

}  // namespace

void serve_phones(Ui& ui, PlayState& play, PhonesState& state) {
    if (state.server) return;
    PhoneServerSettings settings;
    settings.host = state.host;
    settings.page = phone_page();
    auto server = PhoneServer::open(std::move(settings), ui.wake);
    state.fault = server ? std::string() : server.error().message;
    if (!server) return complain(ui, state.fault);
    state.server = *std::move(server);
    state.code = qr_code(state.server->address());
    state.cards_due = true;
    play.phones = state.server;
}

void stop_phones(Ui& ui, Timeline& timeline, PlayState& play, PhonesState& state) {
    if (!state.server) return;
    if (play.choice.id == kPhonesId) choose_device(ui, timeline, play, {});
    end_trials(ui, state);
    end_rating(ui, state);
    play.phones.reset();
    end_phones(state);
    say(ui, "The phones' page is closed.");
}

void end_phones(PhonesState& state) {
    state.server.reset();
    state.code = {};
    state.phones.clear();
    state.said.clear();
    state.patterns_job.forget();
    state.cards_of.reset();
}

bool are_phones_served(const PhonesState& state) { return state.server != nullptr; }

PhonesNews follow_phones(Ui& ui, const Workspace& work, PlayState& play, PhonesState& state) {
    PhonesNews news;
    if (!state.server) return news;
    follow_patterns(ui, work, play, state);
    follow_document(ui, work, state);
    std::vector<ConnectedPhone> now = state.server->phones();
    state.cards_due |= has_new_phone(state.phones, now);
    state.phones = std::move(now);
    const auto until = std::chrono::steady_clock::now() + kAnswersLast;
    for (PhoneAnswer& answer : state.server->take_answers())
        state.waiting.push_back(std::move(answer));
    while (!state.waiting.empty() && std::chrono::steady_clock::now() < until) {
        const PhoneAnswer answer = std::move(state.waiting.front());
        state.waiting.pop_front();
        news.rated |= take_answer(ui, state, answer);
    }
    if (!state.waiting.empty() && ui.wake) ui.wake();
    count_votes(state);
    if (state.trials && is_done(state.trials->trials)) {
        state.tried.insert(state.trials->phone);
        news.all_tried = std::move(state.trials);
        state.trials.reset();
    }
    if (std::exchange(state.cards_due, false)) {
        state.server->show(cards_of(state));
    }
    return news;
}

void ask_phones(PhonesState& state, std::optional<ChoiceCard> question) {
    const bool is_same = question && state.question && question->id == state.question->id;
    if (is_same) question->votes = state.question->votes;
    if (question == state.question) return;
    state.question = std::move(question);
    state.cards_due = true;
}

std::string phones_words(const PhonesState& state) {
    const auto here = std::ranges::count_if(state.phones, &ConnectedPhone::is_here);
    const auto vibrate = std::ranges::count_if(
        state.phones, [](const ConnectedPhone& phone) { return phone.is_here && phone.vibrates; });
    if (here == 0) return "No phone yet";
    const std::string all = counted(static_cast<std::size_t>(here), "phone", "phones");
    if (vibrate == here) return all;
    return all + ", " + std::to_string(vibrate) + " of which " +
           (vibrate == 1 ? "vibrates" : "vibrate");
}

void begin_rating(Ui& ui, Workspace& work, PhonesState& state,
                  const std::filesystem::path& folder) {
    if (!state.server) return;
    auto made = phone_patterns(work.document.set);
    auto rating = class_rating(work.document.set, std::move(made->patterns), folder);
    if (!rating) return complain(ui, rating.error().message);
    end_trials(ui, state);
    state.rating = *std::move(rating);
    state.rating->id = "rating " + std::to_string(++state.ratings_begun);
    state.rating_document = work.document_number;
    state.cards_due = true;
    say(ui, "The phones rate. Every answer goes to " + folder.string());
}

void end_rating(Ui& ui, PhonesState& state) {
    if (!state.rating) return;
    const RatingProgress progress = progress_of(*state.rating);
    state.rating.reset();
    state.cards_due = true;
    say(ui, counted(progress.raters, "phone has", "phones have") + " rated, " +
                std::to_string(progress.finished) + " to the end.");
}

void begin_trials(Ui& ui, const Workspace& work, PhonesState& state, int phone,
                  std::vector<TrialPair> pairs) {
    const auto known = std::ranges::find(state.phones, phone, &ConnectedPhone::number);
    if (!state.cards_of || known == state.phones.end()) return;
    const TrialDesign design{state.trials_asked, ++state.trials_begun, std::move(pairs)};
    auto trials = device_trials(design, state.cards_of->patterns, known->nickname);
    if (!trials) return complain(ui, "No pair of these can be felt on a phone.");
    state.tried.erase(phone);
    state.trials = PhoneTrials{phone, *std::move(trials), state.cards_of->request.set};
    state.trials_document = work.document_number;
    state.cards_due = true;
    say(ui, known->nickname + " feels three at a time; one of them is another pattern.");
}

void end_trials(Ui& ui, PhonesState& state) {
    if (!state.trials) return;
    state.trials.reset();
    state.cards_due = true;
    say(ui, "The trials were stopped.");
}

}  // namespace tact
