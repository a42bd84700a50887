// tactspace phones: a page for the phones in the room, until Ctrl+C.

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <iostream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>

#include "app/command_line/commands.h"
#include "app/command_line/endings.h"
#include "app/command_line/output.h"
#include "app/phones/phones.h"
#include "app/rendering/rendering.h"
#include "devices/phone/phone_server.h"
#include "model/io/set/set_file.h"
#include "model/perceptual_model/perceptual_model.h"
#include "model/set/pattern_set.h"
#include "model/set/set_ratings.h"
#include "model/text/json_fields.h"
#include "model/text/numbers.h"
#include "model/told_apart/told_apart_document.h"
#include "model/told_apart/told_apart_results.h"

namespace tact {

namespace {

// Between the server's threads and the one that answers them.
class News {
  public:
    void come() {
        {
            const std::lock_guard lock(mutex_);
            has_come_ = true;
        }
        changed_.notify_all();
    }
    // False: it is to end.
    bool wait(std::stop_token stop) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, stop, [this] { return has_come_; });
        has_come_ = false;
        return !stop.stop_requested();
    }

  private:
    std::mutex mutex_;
    std::condition_variable_any changed_;
    bool has_come_ = false;
};

// What the phones of this run do: feel, rate, or tell apart.
struct PhoneRun {
    PatternSet set;
    std::vector<PhonePattern> patterns;
    std::optional<ClassRating> rating;
    std::optional<TrialDesign> design;     // of each phone's trials
    std::map<int, DeviceTrials> trials{};  // by the number of the phone
    std::vector<ToldApart> told{};         // of those that came to the end
    std::set<int> known{};                 // phones that were told of
};

void tell(const std::string& sentence) { std::cerr << "tactspace: " << sentence << "\n"; }

std::string card_for(PhoneRun& run, const ConnectedPhone& phone) {
    if (run.rating) return card_of(*run.rating, phone.number, phone.nickname);
    if (!run.design) return feel_card(run.patterns);
    if (!run.trials.contains(phone.number)) {
        TrialDesign own = *run.design;
        own.seed += static_cast<std::uint64_t>(phone.number);
        auto trials = device_trials(own, run.patterns, phone.nickname);
        if (!trials) return thanks_card("No pair of these patterns can be felt on a phone.");
        run.trials.emplace(phone.number, *std::move(trials));
    }
    return card_of(run.trials.at(phone.number));
}

void greet(PhoneRun& run, PhoneServer& server) {
    for (const ConnectedPhone& phone : server.phones()) {
        if (!run.known.insert(phone.number).second) continue;
        tell(phone.nickname + " is here" +
             (phone.vibrates ? "." : "; this browser cannot vibrate."));
        server.show_one(phone.number, card_for(run, phone), false);
    }
}

void take_rated(PhoneRun& run, PhoneServer& server, const PhoneAnswer& answer) {
    const RatedAnswer taken = take_rating(*run.rating, server, answer);
    if (!run.rating->fault.empty()) tell("an answer could not be kept: " + run.rating->fault);
    if (taken.is_kept && taken.is_last) tell(answer.nickname + " has rated all pairs.");
}

void take_tried(PhoneRun& run, PhoneServer& server, const PhoneAnswer& answer) {
    const auto found = run.trials.find(answer.phone);
    if (found == run.trials.end() || !take_trial(found->second, answer.card, answer.json)) return;
    const DeviceTrials& trials = found->second;
    server.show_one(answer.phone, card_of(trials), false);
    if (!is_done(trials)) return;
    run.told.push_back(told_apart_of(trials, run.set));
    const ToldApartResults results = results_of(run.told.back());
    tell(answer.nickname + ": " + share_words(results) + " " + threshold_words(results));
}

void serve(PhoneRun& run, PhoneServer& server, News& news, std::stop_token stop) {
    do {
        greet(run, server);
        for (const PhoneAnswer& answer : server.take_answers()) {
            if (run.rating) take_rated(run, server, answer);
            if (run.design) take_tried(run, server, answer);
        }
    } while (news.wait(stop));
}

// The closest pairs by PM, and some between them and the farthest.
Expected<TrialDesign> trial_design(const PhonesCommand& command, const PatternSet& set,
                                   std::stop_token stop) {
    if (const auto pair = need_a_pair(set, command.common); !pair) return pair.error();
    PredictOptions options;
    options.threads = command.common.threads;
    options.stop = stop;
    const auto prediction = predict(own_waveforms(set, options.threads), set.model, options);
    if (!prediction) return Error{"stopped before the pairs were known"};
    return TrialDesign{command.trials, command.seed, pairs_to_ask(names_of(set), prediction->pm)};
}

Expected<PhoneRun> phone_run(const PhonesCommand& command, std::stop_token stop) {
    Expected<PatternSet> set = load_as_meant(command.common);
    if (!set) return set.error();
    PhoneRun run{*std::move(set), {}, {}, {}};
    auto made = phone_patterns(run.set, stop);
    if (!made) return Error{"stopped before the page was there"};
    run.patterns = std::move(made->patterns);
    if (!command.rate.empty()) {
        run.set.study.repetitions = command.repetitions;
        auto rating = class_rating(run.set, run.patterns, command.rate);
        if (!rating) return rating.error();
        run.rating = *std::move(rating);
    }
    if (command.trials > 0) {
        Expected<TrialDesign> design = trial_design(command, run.set, stop);
        if (!design) return design.error();
        run.design = *std::move(design);
    }
    return run;
}

void show_address(const PhonesCommand& command, const std::string& address) {
    std::ostream& stream = command.common.json ? std::cerr : std::cout;
    const bool is_terminal = isatty(command.common.json ? STDERR_FILENO : STDOUT_FILENO) != 0;
    stream << "Scan this with a phone in the same network, or type the address. Ctrl+C ends it.\n"
           << lines_of(qr_code(address), is_terminal) << address << "\n"
           << std::flush;
}

nlohmann::json json_of(const PhoneRun& run) {
    nlohmann::json json{{"phones", run.known.size()}, {"device", kPhoneDevice}};
    if (run.rating) {
        const RatingProgress progress = progress_of(*run.rating);
        json["rating"] = {{"folder", run.rating->folder.string()},
                          {"raters", progress.raters},
                          {"finished", progress.finished},
                          {"answers", progress.answers}};
    }
    if (run.design) {
        json["told_apart"] = nlohmann::json::array();
        for (const ToldApart& told : run.told) {
            json["told_apart"].push_back(
                nlohmann::json(told_apart_document(told, results_of(told))));
        }
    }
    add_labels(json, {.mark = mark_of(run.set)});
    return json;
}

Expected<Done> keep_told(const PhonesCommand& command, PhoneRun& run) {
    if (command.out.empty()) return Done{};
    auto& all = run.set.told_apart;
    all.insert(all.end(), run.told.begin(), run.told.end());
    return write_set_file(command.out, run.set);
}

Expected<Done> written(const PhonesCommand& command, PhoneRun& run) {
    if (const auto kept = keep_told(command, run); !kept) return kept;
    if (command.common.json) std::cout << text_of_json(json_of(run)) << "\n";
    if (!run.rating) return Done{};
    const RatingProgress progress = progress_of(*run.rating);
    tell(counted(progress.raters, "phone has", "phones have") + " rated, " +
         std::to_string(progress.finished) + " to the end; \"tactspace study " +
         command.rate.string() + "\" says what they felt.");
    return Done{};
}

}  // namespace

Expected<Done> run(const PhonesCommand& command) {
    const Interrupt interrupt(Interrupted::is_the_end);
    if (!command.out.empty()) {
        if (const auto writable = writable_result(command.out); !writable) return writable;
    }
    Expected<PhoneRun> run = phone_run(command, interrupt.token());
    if (!run) return run.error();
    News news;
    PhoneServerSettings settings;
    settings.host = command.host;
    settings.port = command.port;
    settings.page = phone_page();
    const auto server = PhoneServer::open(std::move(settings), [&news] { news.come(); });
    if (!server) return server.error();
    if (!run->design && !run->rating) (*server)->show({feel_card(run->patterns), {}});
    show_address(command, (*server)->address());
    serve(*run, **server, news, interrupt.token());
    return written(command, *run);
}

}  // namespace tact
