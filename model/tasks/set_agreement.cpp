#include "model/tasks/set_agreement.h"

#include <utility>

namespace tact {

std::optional<PeopleAgreement> people_agreement(const RatingStudy& study,
                                                AgreementRequest request) {
    if (request.stop.stop_requested()) return std::nullopt;
    PeopleAgreement agreement;
    Expected<RatedPeople> people = rated_people(study, request.params);
    if (!people) {
        agreement.fault = people.error().message;
        return agreement;
    }
    auto table = metric_table(study, *people, std::move(request));
    if (!table) return std::nullopt;
    agreement.people = *std::move(people);
    agreement.raters = inter_rater(study);
    agreement.table = *std::move(table);
    return agreement;
}

}  // namespace tact
