#include "app/phones/phones.h"

#include <algorithm>
#include <utility>

#include "app/session/program_version.h"
#include "model/io/folders/folder_files.h"
#include "model/io/people/study_lines.h"
#include "model/set/felt_versions.h"
#include "model/set/set_ratings.h"
#include "model/text/utc_time.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

bool is_taken(const ClassRating& rating, const std::string& code) {
    const std::string file = study_file_name(code);
    if (file.empty()) return true;
    const auto has_file = [&](const auto& rater) {
        return study_file_name(rater.second.record.header.participant.code) == file;
    };
    std::error_code none;
    return std::ranges::any_of(rating.raters, has_file) || fs::exists(rating.folder / file, none);
}

// The nickname, or the phone's number where a file cannot have that name; each code is new, as a
// participant's file is never written over.
std::string code_for(const ClassRating& rating, int phone, const std::string& nickname) {
    const bool has_letters = !study_file_name(nickname).empty();
    const std::string wanted = has_letters ? nickname : "phone " + std::to_string(phone);
    if (!is_taken(rating, wanted)) return wanted;
    for (int number = 2;; ++number) {
        const std::string code = wanted + " " + std::to_string(number);
        if (!is_taken(rating, code)) return code;
    }
}

Rater& rater_of(ClassRating& rating, int phone, const std::string& nickname) {
    const auto known = rating.raters.find(phone);
    if (known != rating.raters.end()) return known->second;
    Rater rater;
    StudyHeader& header = rater.record.header;
    header = rating.header;
    header.participant.code = code_for(rating, phone, nickname);
    header.seed = participant_seed(header.design.seed, header.participant.code);
    rater.trials = trial_list(plan_of(header.design, header.patterns.size(), header.seed));
    return rating.raters.emplace(phone, std::move(rater)).first->second;
}

// The file is made with the first answer: whoever only looks takes no part.
Expected<Done> begin_file(const ClassRating& rating, Rater& rater) {
    if (rater.log) return Done{};
    if (const auto made = make_folder(rating.folder); !made) return made;
    StudyHeader& header = rater.record.header;
    header.begun = utc_now();
    auto log = StudyLog::begin(rating.folder / study_file_name(header.participant.code), header);
    if (!log) return log.error();
    rater.log = std::make_unique<StudyLog>(*std::move(log));
    return Done{};
}

PairAnswer answer_of(const PhoneRating& given, const Trial& trial) {
    PairAnswer answer;
    answer.trial = trial;
    answer.similarity = given.similarity;
    answer.plays_left = given.plays_left;
    answer.plays_right = given.plays_right;
    answer.first = given.first;
    answer.response_s = given.response_s;
    answer.at = utc_now();
    return answer;
}

constexpr std::size_t kLeastRatedTogether = 3;
constexpr std::size_t kMostRatedTogether = 10;  // 45 pairs: a quarter of an hour

}  // namespace

bool can_rate_together(std::size_t patterns) {
    return patterns >= kLeastRatedTogether && patterns <= kMostRatedTogether;
}

std::string class_rating_obstacle(const PatternSet& set) {
    const std::size_t count = study_patterns(set).size();
    if (count < kLeastRatedTogether) return "Rating together takes three patterns at least.";
    if (count <= kMostRatedTogether) return {};
    const std::string most = std::to_string(kMostRatedTogether);
    return "The study has " + std::to_string(count) + " patterns, and at most " + most +
           " are rated together: select up to " + most + ".";
}

Expected<ClassRating> class_rating(const PatternSet& set, std::vector<PhonePattern> patterns,
                                   const fs::path& folder) {
    if (const std::string fault = class_rating_obstacle(set); !fault.empty()) return Error{fault};
    ClassRating rating;
    rating.folder = folder;
    StudyHeader& header = rating.header;
    header.program = kProgramVersion;
    header.kind = StudyKind::pairwise;
    header.design = set.study;
    header.design.order = StudyOrder::full;  // what one phone is asked depends on no other
    header.device = {kPhoneDevice, kPhoneStrength, {}};
    header.consented = true;
    describe_set(header, set);
    for (const std::string& name : header.patterns) {
        const auto made = std::ranges::find(patterns, name, &PhonePattern::name);
        if (made == patterns.end()) return Error{"expected \"" + name + "\" among the patterns"};
        rating.patterns.push_back(*made);
    }
    return rating;
}

std::string card_of(ClassRating& rating, int phone, const std::string& nickname) {
    const Rater& rater = rater_of(rating, phone, nickname);
    const std::size_t done = rater.record.answers.size();
    if (done == rater.trials.size()) return thanks_card({});
    return card_of(RatingCard{rating.id, rating.patterns, rater.trials, done});
}

bool take_rating(ClassRating& rating, int phone, const std::string& json) {
    const auto known = rating.raters.find(phone);
    const auto given = rating_answered(json);
    if (known == rating.raters.end() || !given) return false;
    Rater& rater = known->second;
    std::vector<PairAnswer>& answers = rater.record.answers;
    if (given->at != answers.size() || given->at >= rater.trials.size()) return false;
    PairAnswer answer = answer_of(*given, rater.trials[given->at]);
    Expected<Done> kept = begin_file(rating, rater);
    if (kept) {
        kept = rater.log->append(answer_line(rater.record.header, answers.size(), answer));
    }
    rating.fault = kept ? std::string() : kept.error().message;
    if (!kept) return false;
    answers.push_back(std::move(answer));
    return true;
}

RatedAnswer take_rating(ClassRating& rating, PhoneServer& server, const PhoneAnswer& answer) {
    RatedAnswer taken;
    const auto known = rating.raters.find(answer.phone);
    if (known == rating.raters.end()) return taken;
    const Rater& rater = known->second;
    taken.is_kept = take_rating(rating, answer.phone, answer.json);
    taken.is_last = rater.record.answers.size() == rater.trials.size();
    server.show_one(answer.phone, card_of(rating, answer.phone, answer.nickname),
                    taken.is_kept && !taken.is_last);
    return taken;
}

RatingProgress progress_of(const ClassRating& rating) {
    RatingProgress progress;
    for (const auto& [phone, rater] : rating.raters) {
        const std::size_t count = rater.record.answers.size();
        progress.answers += count;
        progress.raters += count > 0 ? 1 : 0;
        progress.finished += count == rater.trials.size() ? 1 : 0;
    }
    return progress;
}

}  // namespace tact
