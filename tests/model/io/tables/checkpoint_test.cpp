#include "model/io/tables/checkpoint.h"

#include <doctest/doctest.h>
#include <sys/stat.h>

#include <map>

#include "tests/support/mutations.h"
#include "tests/support/no_more_than.h"
#include "tests/support/temporary_folder.h"

namespace checkpoint_test {

using namespace tact;

namespace {

constexpr TileKey kKey{.patterns = 9, .side = 4, .vibrations = 40, .model = 41, .codes = 42};

std::vector<double> values_of(std::size_t tile) {
    std::vector<double> values(pair_count(tile_at(kKey.patterns, tile)));
    for (std::size_t k = 0; k < values.size(); ++k) values[k] = 0.1 * static_cast<double>(k + tile);
    return values;
}

using Tiles = std::map<std::size_t, std::vector<double>>;

Tiles tiles_in(const Checkpoint& checkpoint, Part part) {
    Tiles tiles;
    const auto read = checkpoint.read(part, [&](std::size_t tile, auto values) {
        tiles[tile].assign(values.begin(), values.end());
    });
    REQUIRE(read);
    return tiles;
}

// A file with two tiles of NC and one, the last, of OC.
std::filesystem::path three_tiles(const TemporaryFolder& folder) {
    const auto path = folder.path / "m.csv.tiles";
    auto checkpoint = Checkpoint::open(path, kKey);
    REQUIRE(checkpoint);
    REQUIRE(checkpoint->append(Part::nc, 3, values_of(3)));
    REQUIRE(checkpoint->append(Part::nc, 0, values_of(0)));
    REQUIRE(checkpoint->append(Part::oc, 1, values_of(1)));
    return path;
}

}  // namespace

TEST_CASE("checkpoint: tiles come back as they were, each in its part") {
    const TemporaryFolder folder;
    const auto path = three_tiles(folder);
    const auto checkpoint = Checkpoint::open(path, kKey);
    REQUIRE(checkpoint);
    CHECK(tiles_in(*checkpoint, Part::nc) == Tiles{{0, values_of(0)}, {3, values_of(3)}});
    CHECK(tiles_in(*checkpoint, Part::oc) == Tiles{{1, values_of(1)}});
}

TEST_CASE(
    "checkpoint: a torn last tile is cut off, wherever it was torn, and can be appended again") {
    const TemporaryFolder folder;
    const auto path = three_tiles(folder);
    const std::string whole = bytes_of(path);
    const std::size_t last = 16 + values_of(1).size() * sizeof(double);
    for (std::size_t lost = 1; lost <= last; ++lost) {
        CAPTURE(lost);
        folder.write("m.csv.tiles", std::string_view(whole).substr(0, whole.size() - lost));
        {
            auto checkpoint = Checkpoint::open(path, kKey);
            REQUIRE(checkpoint);
            CHECK(tiles_in(*checkpoint, Part::nc).size() == 2);
            CHECK(tiles_in(*checkpoint, Part::oc).empty());
            REQUIRE(checkpoint->append(Part::oc, 1, values_of(1)));
        }
        CHECK(bytes_of(path) == whole);
    }
}

TEST_CASE("checkpoint: a byte that changed anywhere in a tile costs that tile") {
    const TemporaryFolder folder;
    const auto path = three_tiles(folder);
    const std::string whole = bytes_of(path);
    const std::size_t last = 16 + values_of(1).size() * sizeof(double);
    for (std::size_t from_end = 1; from_end <= last; ++from_end) {
        CAPTURE(from_end);
        std::string bytes = whole;
        bytes[bytes.size() - from_end] = static_cast<char>(bytes[bytes.size() - from_end] ^ 1);
        folder.write("m.csv.tiles", bytes);
        const auto checkpoint = Checkpoint::open(path, kKey);
        REQUIRE(checkpoint);
        CHECK(tiles_in(*checkpoint, Part::nc).size() == 2);
        CHECK(tiles_in(*checkpoint, Part::oc).empty());
    }
}

TEST_CASE("checkpoint: damage in the middle costs the tiles that it is in, and is counted") {
    const TemporaryFolder folder;
    const auto path = three_tiles(folder);
    const std::string whole = bytes_of(path);
    const std::size_t last = 16 + values_of(1).size() * sizeof(double);
    // Any byte of all records but the last.
    for (std::size_t at = 64; at < whole.size() - last; ++at) {
        CAPTURE(at);
        std::string bytes = whole;
        bytes[at] = static_cast<char>(bytes[at] ^ 4);
        folder.write("m.csv.tiles", bytes);
        auto checkpoint = Checkpoint::open(path, kKey);
        REQUIRE(checkpoint);
        CHECK(checkpoint->damaged_places() == 1);
        CHECK(tiles_in(*checkpoint, Part::nc).size() == 1);
        CHECK(tiles_in(*checkpoint, Part::oc).size() == 1);
        // What is made again is appended, and found beside the rest.
        const std::size_t lost = tiles_in(*checkpoint, Part::nc).contains(0) ? 3 : 0;
        REQUIRE(checkpoint->append(Part::nc, lost, values_of(lost)));
        { const auto gone = std::move(*checkpoint); }
        const auto again = Checkpoint::open(path, kKey);
        REQUIRE(again);
        CHECK(tiles_in(*again, Part::nc).size() == 2);
        CHECK(tiles_in(*again, Part::oc).size() == 1);
    }
}

TEST_CASE("checkpoint: a header that was cut short is begun again") {
    const TemporaryFolder folder;
    const auto path = three_tiles(folder);
    const std::string whole = bytes_of(path);
    for (const std::size_t left : {0UL, 1UL, 20UL, 63UL}) {
        CAPTURE(left);
        folder.write("m.csv.tiles", std::string_view(whole).substr(0, left));
        const auto checkpoint = Checkpoint::open(path, kKey);
        REQUIRE(checkpoint);
        CHECK(tiles_in(*checkpoint, Part::nc).empty());
        CHECK(bytes_of(path) == whole.substr(0, 64));
    }
}

TEST_CASE("checkpoint: one of another matrix is refused and left as it was") {
    const TemporaryFolder folder;
    const auto path = three_tiles(folder);
    const std::string whole = bytes_of(path);
    const auto refused = [&](const TileKey& other, const std::string& reason) {
        const auto checkpoint = Checkpoint::open(path, other);
        REQUIRE_FALSE(checkpoint);
        CHECK(checkpoint.error().message.starts_with(path.string() + ": " + reason));
        CHECK(bytes_of(path) == whole);
    };
    refused({10, 4, 40, 41, 42}, "belongs to other patterns;");
    refused({9, 4, 50, 41, 52}, "belongs to other patterns;");
    refused({9, 4, 40, 51, 52}, "belongs to other parameters of the model;");
    refused({9, 4, 50, 51, 52}, "belongs to other patterns and other parameters of the model;");
    // Only the arithmetic can have been another.
    refused({9, 4, 40, 41, 52}, "was begun by another build of tactspace, or on a machine with");
    refused({9, 8, 40, 41, 42}, "was begun by another build of tactspace, or on a machine with");
}

TEST_CASE("checkpoint: other versions and other byte orders are refused") {
    const TemporaryFolder folder;
    const auto path = three_tiles(folder);
    for (const std::size_t place : {16UL, 20UL}) {
        std::string bytes = bytes_of(path);
        bytes[place] = static_cast<char>(bytes[place] ^ 7);
        const auto changed = folder.write("changed.tiles", bytes);
        const auto checkpoint = Checkpoint::open(changed, kKey);
        REQUIRE_FALSE(checkpoint);
        CHECK(contains(checkpoint.error().message, "another version"));
        CHECK(bytes_of(changed) == bytes);
    }
}

TEST_CASE("checkpoint: what is none is refused and left as it was") {
    const TemporaryFolder folder;
    for (const std::string_view text : {"a", "tactspace\n", ",p1,p2\np1,0,1\np2,1,0\n"}) {
        const auto path = folder.write("mine.csv.tiles", text);
        const auto checkpoint = Checkpoint::open(path, kKey);
        REQUIRE_FALSE(checkpoint);
        CHECK(contains(checkpoint.error().message, "is no checkpoint"));
        CHECK(bytes_of(path) == text);
    }
    CHECK_FALSE(Checkpoint::open(folder.path, kKey));
    CHECK_FALSE(Checkpoint::open(folder.path / "no" / "folder.tiles", kKey));
}

TEST_CASE(
    "checkpoint: what is no file is none to be kept, at once and in the words of all readers") {
    const TemporaryFolder folder;
    const auto pipe = folder.path / "pipe.tiles";
    REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
    CHECK(Checkpoint::open(pipe, kKey).error().message ==
          pipe.string() + ": is a pipe, expected a file");
    CHECK(Checkpoint::open("/dev/null", kKey).error().message ==
          "/dev/null: is a device, expected a file");
    CHECK(Checkpoint::open(folder.path, kKey).error().message ==
          folder.path.string() + ": is a folder, expected a file");
}

TEST_CASE("checkpoint: after an accident it is refused as it is, or gives true tiles, and again") {
    const TemporaryFolder folder;
    const std::string whole = bytes_of(three_tiles(folder));
    const auto path = folder.path / "hurt.tiles";
    std::size_t accepted = 0;
    for (unsigned seed = 0; seed < 400; ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        const std::string hurt = after_mishaps(whole, random);
        folder.write("hurt.tiles", hurt);
        Tiles nc;
        Tiles oc;
        {
            const auto checkpoint = Checkpoint::open(path, kKey);
            if (!checkpoint) {
                CHECK(contains(checkpoint.error().message, "hurt.tiles: "));
                CHECK(bytes_of(path) == hurt);
                continue;
            }
            nc = tiles_in(*checkpoint, Part::nc);
            oc = tiles_in(*checkpoint, Part::oc);
        }
        ++accepted;
        for (const auto& [tile, values] : nc)
            CHECK(((tile == 0 || tile == 3) && values == values_of(tile)));
        for (const auto& [tile, values] : oc) CHECK((tile == 1 && values == values_of(tile)));
        const auto again = Checkpoint::open(path, kKey);
        REQUIRE(again);
        CHECK(tiles_in(*again, Part::nc) == nc);
        CHECK(tiles_in(*again, Part::oc) == oc);
    }
    CHECK(accepted > 100);
}

TEST_CASE("checkpoint: two runs cannot have it open at once") {
    const TemporaryFolder folder;
    const auto path = folder.path / "m.csv.tiles";
    {
        const auto first = Checkpoint::open(path, kKey);
        REQUIRE(first);
        const auto second = Checkpoint::open(path, kKey);
        REQUIRE_FALSE(second);
        CHECK(contains(second.error().message, "another tactspace"));
    }
    CHECK(Checkpoint::open(path, kKey));
}

TEST_CASE("checkpoint: a tile that finds no room is reported, and those before it stay") {
    const TemporaryFolder folder;
    const auto path = three_tiles(folder);
    {
        auto checkpoint = Checkpoint::open(path, kKey);
        REQUIRE(checkpoint);
        const NoMoreThan no_room(std::filesystem::file_size(path) + 20);
        const auto appended = checkpoint->append(Part::oc, 0, values_of(0));
        REQUIRE_FALSE(appended);
        CHECK(contains(appended.error().message, "m.csv.tiles: cannot be written: "));
    }
    const auto checkpoint = Checkpoint::open(path, kKey);
    REQUIRE(checkpoint);
    CHECK(tiles_in(*checkpoint, Part::nc).size() == 2);
    CHECK(tiles_in(*checkpoint, Part::oc).size() == 1);
}

TEST_CASE("checkpoint: when the work is done the file goes") {
    const TemporaryFolder folder;
    auto checkpoint = Checkpoint::open(folder.path / "m.csv.tiles", kKey);
    REQUIRE(checkpoint);
    CHECK(file_count(folder.path) == 1);
    checkpoint->remove();
    CHECK(file_count(folder.path) == 0);
}

}  // namespace checkpoint_test
