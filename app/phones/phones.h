// Phones in the room: who is there, what they feel, rate and tell apart.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "app/document/workspace.h"
#include "app/jobs/jobs.h"
#include "app/play/play.h"
#include "app/timeline/timeline.h"
#include "app/ui/ui.h"
#include "devices/http/network_interfaces.h"
#include "devices/phone/phone_server.h"
#include "model/common/expected.h"
#include "model/io/people/study_file.h"
#include "model/set/pattern_set.h"
#include "model/study/study_record.h"
#include "model/told_apart/odd_trials.h"

namespace tact {

// The patterns of a set as phones play them: on-off times.
//
// A phone's motor knows no g: the loudest of the set is full strength, and the others are in
// proportion to it, so that the set feels as one whatever phone it is felt on.
//
// Output    one pattern each, in the order of the set; a recording as well
// Exact     same set, same times.

struct PhonePattern {
    std::string name;
    std::vector<int> ms;  // on, off, on, ..
    std::string loss;     // what of it is not felt, a sentence; empty: all is

    bool operator==(const PhonePattern&) const = default;
};

// How the patterns reached the skin, as a study's file and a measurement have it.
inline constexpr const char* kPhoneDevice = "phones (web vibration)";
inline constexpr const char* kPhoneStrength =
    "uncalibrated, on-off times alone: amplitude as the share of time that the motor runs";

struct PhonePatterns {
    std::vector<PhonePattern> patterns;
    double full_scale_g = 1.0;  // that counts as full strength: the loudest's peak; 1 for silence
};

// Nothing when stopped.
std::optional<PhonePatterns> phone_patterns(const PatternSet& set, std::stop_token stop = {});

// What a phone shows, and what it answers: cards and answers as JSON.
//
// The page (assets/phone) puts every text of a card in place as text, never as markup.
//
// Output    JSON objects, of keys that the page knows; no value for an answer that does not fit its
// card

std::string wait_card();

// A list to tap, each of which is felt.
std::string feel_card(std::span<const PhonePattern> patterns);

struct ChoiceCard {
    std::string id;
    std::string ask;
    std::vector<std::string> options;
    std::vector<int> ms{};              // to be felt with the question; empty: nothing
    std::optional<std::size_t> mine{};  // what this phone has said
    bool revealed = false;              // then the three below are shown
    std::vector<std::size_t> right{};
    std::vector<int> votes{};  // of each option
    std::string reveal{};

    bool operator==(const ChoiceCard&) const = default;
};
std::string card_of(const ChoiceCard& card);
std::optional<std::size_t> option_answered(const std::string& json, std::size_t options);

// Three plays, of which one is another: which?
struct TrialCard {
    std::string id;
    int at = 1;  // of the trials, from 1
    int of = 1;
    std::vector<std::vector<int>> ms;
};
std::string card_of(const TrialCard& card);

struct PhoneTrial {
    int place = 0;  // of the one that was taken for another
    double response_s = 0.0;
};
// None unless all three were felt.
std::optional<PhoneTrial> trial_answered(const std::string& json);

// All trials of one rater, who is at `done`.
struct RatingCard {
    std::string id;
    std::span<const PhonePattern> patterns;
    std::span<const Trial> trials;
    std::size_t done = 0;
};
std::string card_of(const RatingCard& card);

struct PhoneRating {
    std::size_t at = 0;  // of the trials, from 0
    double similarity = 0.0;
    int plays_left = 0;
    int plays_right = 0;
    FeltFirst first = FeltFirst::unknown;
    double response_s = 0.0;
};
// None unless both sides were felt, and the similarity lies in 0..100.
std::optional<PhoneRating> rating_answered(const std::string& json);

std::string thanks_card(const std::string& text);

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

bool can_rate_together(std::size_t patterns);

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

// Which of three plays is another one: trials on one phone, one after the other.
//
// Source    model/told_apart: which pair is asked next, and what the answers say
// Output    what one person told apart on one phone; never a part of PM
// Left out  keeping it with the set

inline constexpr int kUsualTrials = 20;

struct DeviceTrials {
    TrialDesign design;
    std::vector<OddAnswer> answers;
    std::optional<OddOneOut> now;                  // none: all are answered
    std::map<std::string, std::vector<int>> ms{};  // of the patterns, by name
    std::string person;                            // the phone's nickname
};

// None without a pair that can be felt on a phone.
std::optional<DeviceTrials> device_trials(const TrialDesign& design,
                                          const std::vector<PhonePattern>& patterns,
                                          const std::string& person);

bool is_done(const DeviceTrials& trials);

// The card of the trial that is on, or thanks.
std::string card_of(const DeviceTrials& trials);

// True: it answers the trial that is on, with each of the three felt.
bool take_trial(DeviceTrials& trials, const std::string& card, const std::string& json);

// "Kim: trial 7 of 20".
std::string words_on(const DeviceTrials& trials);

// As the set keeps it, with the versions of the patterns.
ToldApart told_apart_of(const DeviceTrials& trials, const PatternSet& set);

// The page that phones open, as it is compiled in.

std::vector<PageFile> phone_page();

// An address as a QR code, which a phone's camera reads.
//
// Source    ISO/IEC 18004, by libqrencode; the quiet zone of four modules around it is the
//           standard's
// Valid     addresses of at most some hundred characters

inline constexpr std::size_t kQuietModules = 4;

struct QrCode {
    std::size_t side = 0;    // modules, without the quiet zone; 0: the text is too long
    std::vector<bool> dark;  // row by row

    bool operator==(const QrCode&) const = default;
};

QrCode qr_code(const std::string& text);

// Lines of half blocks with the quiet zone, two modules a line. `coloured`: with a terminal's codes
// for black on white, as cameras expect it; otherwise what is light is drawn, which fits terminals
// of light text on a dark ground.
std::string lines_of(const QrCode& code, bool coloured);

// Phones as actuators, raters and answer sheets: the server, who is connected, what is under way.

// The patterns of a revision, to be made for phones.
struct PhonePatternsRequest {
    std::uint64_t document = 0;
    std::uint64_t revision = 0;
    std::shared_ptr<const PatternSet> set;

    bool operator==(const PhonePatternsRequest& other) const {
        return document == other.document && revision == other.revision;
    }
};

struct MadePhonePatterns {
    PhonePatternsRequest request;
    std::vector<PhonePattern> patterns;
    double full_scale_g = 1.0;
};

// The trials of one phone, and how they went.
struct PhoneTrials {
    int phone = 0;
    DeviceTrials trials;
    std::shared_ptr<const PatternSet> felt;  // the set as it was when they began
};

struct PhonesState {
    std::shared_ptr<PhoneServer> server;  // null: off
    QrCode code;                          // of its address
    std::string host;                     // it is to listen on; empty: the first private one
    std::vector<NetworkInterface> interfaces;
    std::string fault;                   // why it could not be opened; a sentence
    std::vector<ConnectedPhone> phones;  // of this frame

    Query<PhonePatternsRequest, MadePhonePatterns> patterns_job;
    std::optional<PhoneTrials> trials;
    std::uint64_t trials_document = 0;  // whose patterns they are
    int trials_asked = kUsualTrials;    // of the next ones
    std::uint64_t trials_begun = 0;     // since the program began: the seed of the next
    std::set<int> tried{};              // phones that were thanked for their trials
    std::optional<ClassRating> rating;
    std::uint64_t rating_document = 0;
    std::uint64_t ratings_begun = 0;
    int repetitions = 1;                 // of every pair, in the next one
    std::optional<ChoiceCard> question;  // of a lesson, while it asks
    // Options said to each question, by its id and the number of the phone.
    std::map<std::string, std::map<int, std::size_t>> said;
    bool cards_due = false;                             // something of it has changed
    std::shared_ptr<const MadePhonePatterns> cards_of;  // the patterns of the cards
    std::deque<PhoneAnswer> waiting;                    // to be taken, one after the other
};

// The dialog on phones: the code to scan, who is here, and what they do.

// What the dialog asks of rooms that it does not know.
struct PhonesActions {
    std::optional<int> trials_on;  // the phone that is to try the closest pairs
    bool rate_together = false;
    bool show_answers = false;  // of the rating, where studies are
};

inline constexpr Dialog kPhonesDialog{.title = "Phones"};
PhonesActions draw_phones_dialog(Ui& ui, Workspace& work, Timeline& timeline, PlayState& play,
                                 PhonesState& state);

// Phones of the room: the page served and withdrawn, and each frame what they are shown and say.
//
// Left out  the lesson and the folder of a study, which are other rooms': app/classroom/classroom.h

void serve_phones(Ui& ui, PlayState& play, PhonesState& state);
// Everything that was under way ends; what has been answered is kept.
void stop_phones(Ui& ui, Timeline& timeline, PlayState& play, PhonesState& state);
// At the end of the program, without a word.
void end_phones(PhonesState& state);

bool are_phones_served(const PhonesState& state);

// What came of a frame, for other rooms.
struct PhonesNews {
    bool rated = false;                    // an answer of a rating was kept
    std::optional<PhoneTrials> all_tried;  // trials that have come to their end
};
// Each frame, before follow_sound.
PhonesNews follow_phones(Ui& ui, const Workspace& work, PlayState& play, PhonesState& state);

// What the lesson asks now; none: nothing. It comes before everything else that phones show.
void ask_phones(PhonesState& state, std::optional<ChoiceCard> question);

// "3 phones, 2 of which vibrate": who is here now.
std::string phones_words(const PhonesState& state);

void begin_rating(Ui& ui, Workspace& work, PhonesState& state, const std::filesystem::path& folder);
void end_rating(Ui& ui, PhonesState& state);

// Pairs of the map that is shown, with their PM.
void begin_trials(Ui& ui, const Workspace& work, PhonesState& state, int phone,
                  std::vector<TrialPair> pairs);
void end_trials(Ui& ui, PhonesState& state);

}  // namespace tact
