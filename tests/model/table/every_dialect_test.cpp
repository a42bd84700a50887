// A table is the same whoever wrote it: matrices, ratings, places and accelerations in every way of
// writing that model/table/table.h names are read back equal.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "model/io/people/ratings_file.h"
#include "model/io/recordings/acceleration_file.h"
#include "model/io/tables/coordinates_file.h"
#include "model/io/tables/matrix_file.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"
#include "tests/support/temporary_folder.h"

namespace every_dialect_test {

using namespace tact;

namespace {

struct Writing {
    char separator = ',';
    char decimal = '.';
    bool in_quotes = false;  // every cell
    const char* line_end = "\n";
    const char* before = "";  // the first row
    enum { utf8, with_mark, utf16, windows } encoding = utf8;
};

// Cells of numbers carry a point; all others are names.
using Cells = std::vector<std::vector<std::string>>;

std::string utf16_of(const std::string& text) {
    std::string bytes = "\xFF\xFE";
    for (std::size_t at = 0; at < text.size();) {
        const auto lead = static_cast<unsigned char>(text[at]);
        std::uint32_t sign = lead;
        if (lead >= 0x80U) {
            sign = (lead & 0x1FU) << 6U | (static_cast<unsigned char>(text[at + 1]) & 0x3FU);
        }
        at += lead >= 0x80U ? 2 : 1;
        bytes += static_cast<char>(sign & 0xFFU);
        bytes += static_cast<char>(sign >> 8U);
    }
    return bytes;
}

std::string windows_of(const std::string& text) {
    std::string bytes;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const auto lead = static_cast<unsigned char>(text[at]);
        if (lead < 0x80U) {
            bytes += text[at];
            continue;
        }
        const auto next = static_cast<unsigned char>(text[++at]);
        bytes += static_cast<char>((lead & 0x03U) << 6U | (next & 0x3FU));
    }
    return bytes;
}

std::string written(const Cells& cells, const Writing& how) {
    std::string text = how.before;
    for (const auto& row : cells) {
        for (std::size_t k = 0; k < row.size(); ++k) {
            std::string cell = row[k];
            const bool is_number = finite_number_in(cell).has_value();
            if (is_number && how.decimal == ',') {
                for (char& c : cell) c = c == '.' ? ',' : c;
            }
            const bool needs_quotes =
                cell.find(how.separator) != cell.npos || (how.separator == ' ' && cell.empty());
            const bool quotes = how.in_quotes || needs_quotes;
            text += (k > 0 ? std::string(1, how.separator) : "") + (quotes ? "\"" : "") + cell +
                    (quotes ? "\"" : "");
        }
        text += how.line_end;
    }
    if (how.encoding == Writing::with_mark) return "\xEF\xBB\xBF" + text;
    if (how.encoding == Writing::utf16) return utf16_of(text);
    if (how.encoding == Writing::windows) return windows_of(text);
    return text;
}

std::string name_of(const Writing& how) {
    return std::string("separator '") + how.separator + "' decimal '" + how.decimal + "' quotes " +
           (how.in_quotes ? "yes" : "no") + " encoding " + std::to_string(how.encoding) +
           " before \"" + how.before + "\" end " + std::to_string(std::string(how.line_end)[0]) +
           std::to_string(std::string(how.line_end).size());
}

void in_every_writing(const std::function<void(const Writing&)>& check) {
    for (const char separator : {',', ';', '\t', ' '}) {
        for (const char decimal : {'.', ','}) {
            for (const bool in_quotes : {false, true}) {
                for (const char* line_end : {"\n", "\r\n", "\r"}) {
                    for (const char* before : {"", "# made by hand\n\n", "% by a lab\r\n"}) {
                        for (const auto encoding : {Writing::utf8, Writing::with_mark,
                                                    Writing::utf16, Writing::windows}) {
                            check({separator, decimal, in_quotes, line_end, before, encoding});
                        }
                    }
                }
            }
        }
    }
}

const std::vector<std::string> kNames{"soft low", "h\u00e4rter", "a1", "\u00fcber"};

// Five digits behind the point: three could be thousands.
std::string number(std::mt19937& random, double least, double most) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4f1",
                  std::uniform_real_distribution<double>(least, most)(random));
    return text;
}

}  // namespace

TEST_CASE("every dialect: a matrix is read back equal") {
    std::mt19937 random(20261127);
    in_every_writing([&](const Writing& how) {
        CAPTURE(name_of(how));
        Cells cells{{""}};
        cells[0].insert(cells[0].end(), kNames.begin(), kNames.end());
        std::vector<std::vector<std::string>> value(4, std::vector<std::string>(4, "0"));
        for (std::size_t i = 0; i < 4; ++i) {
            for (std::size_t j = i + 1; j < 4; ++j) {
                value[i][j] = value[j][i] = number(random, 0.0, 90.0);
            }
        }
        for (std::size_t i = 0; i < 4; ++i) {
            cells.push_back({kNames[i]});
            cells.back().insert(cells.back().end(), value[i].begin(), value[i].end());
        }
        const auto read = parse_matrix(written(cells, how), "m.csv");
        REQUIRE_MESSAGE(read, (read ? "" : read.error().message));
        CHECK(read->labels == kNames);
        for (std::size_t i = 0; i < 4; ++i) {
            for (std::size_t j = i + 1; j < 4; ++j) {
                CHECK(read->dissimilarity(i, j) == *finite_number_in(value[i][j]));
            }
        }
    });
}

TEST_CASE("every dialect: places are read back equal") {
    std::mt19937 random(20261128);
    in_every_writing([&](const Writing& how) {
        CAPTURE(name_of(how));
        Cells cells{{"name", "D1", "D2"}};
        for (const std::string& name : kNames) {
            cells.push_back({name, number(random, -5.0, 5.0), number(random, -5.0, 5.0)});
        }
        const auto read = parse_coordinates(written(cells, how), "p.csv");
        REQUIRE_MESSAGE(read, (read ? "" : read.error().message));
        CHECK(read->labels == kNames);
        REQUIRE(read->points.cols() == 2);
        for (Eigen::Index i = 0; i < 4; ++i) {
            CHECK(read->points(i, 0) ==
                  *finite_number_in(cells[static_cast<std::size_t>(i) + 1][1]));
            CHECK(read->points(i, 1) ==
                  *finite_number_in(cells[static_cast<std::size_t>(i) + 1][2]));
        }
    });
}

TEST_CASE("every dialect: ratings are read back equal") {
    std::mt19937 random(20261129);
    in_every_writing([&](const Writing& how) {
        CAPTURE(name_of(how));
        Cells cells{{"participant", "a", "b", "rating"}};
        for (std::size_t i = 0; i < 4; ++i) {
            for (std::size_t j = i + 1; j < 4; ++j) {
                cells.push_back({"S1", kNames[i], kNames[j], number(random, 0.0, 100.0)});
            }
        }
        const auto read =
            parse_ratings(written(cells, how), "r.csv", RatingScale::dissimilarity, {}, {});
        REQUIRE_MESSAGE(read, (read ? "" : read.error().message));
        REQUIRE(read->study.judgements.size() == 1);
        const auto& labels = read->study.labels;
        CHECK(labels.size() == 4);
        const auto place = [&labels](const std::string& name) {
            return static_cast<std::size_t>(std::ranges::find(labels, name) - labels.begin());
        };
        const Dissimilarity rated{4, read->study.judgements[0].condensed};
        for (std::size_t k = 1; k < cells.size(); ++k) {
            const std::size_t i = place(cells[k][1]);
            const std::size_t j = place(cells[k][2]);
            REQUIRE(i < 4);
            REQUIRE(j < 4);
            CHECK(rated(i, j) == *finite_number_in(cells[k][3]));
        }
    });
}

TEST_CASE("every dialect: a recording is read back equal") {
    const TemporaryFolder folder;
    std::mt19937 random(20261130);
    Cells cells{{"time (s)", "x (g)"}};
    for (int n = 0; n < 300; ++n) {
        cells.push_back({significant_digits(0.001 * n + 0.0001, 8), number(random, -2.0, 2.0)});
    }
    std::optional<Waveform> first;
    in_every_writing([&](const Writing& how) {
        CAPTURE(name_of(how));
        const auto read = read_acceleration_file(folder.write("a.csv", written(cells, how)));
        REQUIRE_MESSAGE(read, (read ? "" : read.error().message));
        if (!first) first = read->waveform;
        CHECK(read->waveform.samples_g == first->samples_g);
    });
}

}  // namespace every_dialect_test
