// A class that rates together: every phone its own order, every answer on the disk at once.
//
// The study is a folder as any other (model/io/people/study_file.h): a file for each phone that has
// answered, by its nickname. What is kept is on the page before anybody starts.
//
// Source    the order of pairs: model/study/pairwise_study.h
// Valid     3 to 10 patterns
// Output    an answer is taken when its line is on the disk
// Left out  the training that a study in the window has: the first trials are the training
// Errors    the folder or a file cannot be written; sentences
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/phones/phone_cards.h"
#include "app/phones/phone_patterns.h"
#include "devices/phone/phone_server.h"
#include "model/common/expected.h"
#include "model/io/people/study_file.h"
#include "model/set/pattern_set.h"
#include "model/study/study_record.h"

namespace tact {

inline constexpr std::size_t kLeastRatedTogether = 3;
inline constexpr std::size_t kMostRatedTogether = 10;  // 45 pairs: a quarter of an hour

struct Rater {
    StudyRecord record;
    std::vector<Trial> trials;
    std::unique_ptr<StudyLog> log;  // null until the first answer
};

struct ClassRating {
    std::string id = "rating 1";  // of its cards: each round has its own
    std::filesystem::path folder;
    StudyHeader header;                  // of everyone, but for the code, the seed and the time
    std::vector<PhonePattern> patterns;  // that take part, in the header's order
    std::map<int, Rater> raters;         // by the number of the phone
    std::string fault{};                 // why the last answer could not be kept; empty: it was
};

// Why these cannot be rated together, a sentence; empty: they can.
std::string class_rating_obstacle(const PatternSet& set);

// The set's study: its patterns, its repetitions. The folder is made with the first answer.
Expected<ClassRating> class_rating(const PatternSet& set, std::vector<PhonePattern> patterns,
                                   const std::filesystem::path& folder);

// The card of a phone, whose order is made when it is seen for the first time.
std::string card_of(ClassRating& rating, int phone, const std::string& nickname);

// True: the answer is on the disk, and the phone's card is another one. False: it answers no trial
// that is to come (a page that was late), or it cannot be kept, which `fault` says.
bool take_rating(ClassRating& rating, int phone, const std::string& json);

// The same of an answer that has come, and the phone's page told: it continues by itself unless the
// answer was not kept, or was the last.
struct RatedAnswer {
    bool is_kept = false;
    bool is_last = false;
};
RatedAnswer take_rating(ClassRating& rating, PhoneServer& server, const PhoneAnswer& answer);

struct RatingProgress {
    std::size_t raters = 0;  // who have answered
    std::size_t finished = 0;
    std::size_t answers = 0;
};
RatingProgress progress_of(const ClassRating& rating);

}  // namespace tact
