// A study as a dataset that archives of psychology read: Psych-DS.
//
//     dataset_description.json                        what it is, and every column in words
//     README.md
//     data/task-rating_description-answers_data.csv   an answer a line
//     (model/io/people/study_csv.h) data/task-rating_description-people_data.csv    a participant a
//     line materials/SET.tactspace.json                    what was felt
//
// Source    Psych-DS schema, psychds-docs.readthedocs.io (2026): dataset_description.json in the
//           root with schema.org's name, description and variableMeasured; data/ with at least one
//           CSV, named (keyword-value_)*data.csv, whose columns are all in variableMeasured
// Output    files by their paths in the dataset; everyone, who does not count marked
// Left out  licence and authors: a person fills them in.
// Exact     same input, same bytes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/common/expected.h"
#include "model/set/pattern_set.h"
#include "model/study/study_results.h"

namespace tact {

struct DatasetFile {
    std::string path;  // with '/' between
    std::string text;
};

struct StudyDataset {
    std::string name;
    std::string program;  // with its version
    std::string date;     // of the dataset
    std::vector<StudyRecord> records;
    StudyResults results;
    PatternSet set;
};

std::vector<DatasetFile> psych_ds_files(const StudyDataset& study);

// What the standard asks for and a dataset lacks: sentences without a full stop; none of one that
// is in order. The rules that its validator calls errors.
std::vector<std::string> psych_ds_faults(const std::vector<DatasetFile>& files);

}  // namespace tact
