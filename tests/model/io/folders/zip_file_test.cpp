#include "model/io/folders/zip_file.h"

#include <doctest/doctest.h>
#include <sys/resource.h>

#include <chrono>

#include "model/io/folders/folder_files.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/zip_bytes.h"

namespace zip_file_test {

using namespace tact;
namespace fs = std::filesystem;

namespace {

std::string fault_of(const fs::path& path) {
    const auto zip = open_zip_file(path);
    REQUIRE_FALSE(zip);
    return zip.error().message;
}

long most_memory_kb() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

std::string some_bytes(std::size_t count) {
    std::string bytes;
    std::uint32_t state = 1;
    for (std::size_t k = 0; k < count; ++k) {
        state = state * 1664525U + 1013904223U;
        bytes += static_cast<char>(state >> 24 & 0x3FU);
    }
    return bytes;
}

}  // namespace

TEST_CASE("zip: stored, deflated and large archives give back what was packed") {
    const TemporaryFolder folder;
    const std::string large = some_bytes(300'000);
    for (const bool is_large : {false, true}) {
        for (const char* before : {"", "#!/bin/sh\n"}) {
            const fs::path path = folder.write(
                "a.zip", zip_of({{"a.txt", "0\n1\n", false}, {"b/", ""}, {"b/c.txt", large}},
                                is_large, before));
            CHECK(is_zip_file(path) == std::string_view(before).empty());
            const auto zip = open_zip_file(path);
            REQUIRE_MESSAGE(zip, (zip ? "" : zip.error().message));
            REQUIRE(zip->entries.size() == 3);
            CHECK(zip->entries[2].name == "b/c.txt");
            CHECK(*unpacked(*zip, zip->entries[0], 4) == "0\n1\n");
            CHECK(*unpacked(*zip, zip->entries[2], 300'000) == large);
            CHECK(unpacked_head(*zip, zip->entries[2], 100) == large.substr(0, 100));
            CHECK(unpacked_head(*zip, zip->entries[0], 100) == "0\n1\n");
            CHECK(unpacked(*zip, zip->entries[2], 299'999).error().message ==
                  path.string() + "/b/c.txt: expected at most 299,999 bytes, got 300,000");
        }
    }
}

TEST_CASE("zip: files that cannot be read are named with their reason, the others are read") {
    const TemporaryFolder folder;
    ZipMember secret{"secret.wav", "abc"};
    secret.is_encrypted = true;
    ZipMember link{"link.wav", "/etc/passwd", false};
    link.is_link = true;
    ZipMember other{"other.wav", "abc"};
    other.method = 14;
    const fs::path path = folder.write("a.zip", zip_of({{"good.txt", "1\n"},
                                                        secret,
                                                        link,
                                                        other,
                                                        {"../out.wav", ""},
                                                        {"a/../../out.wav", ""},
                                                        {"/root.wav", ""},
                                                        {"C:\\drive.wav", ""},
                                                        {"a\\back.txt", "2\n"},
                                                        {"Kl\x84nge.txt", "3\n"},
                                                        {"line\nend", ""},
                                                        {"good.txt", "4\n"},
                                                        {".hidden", ""},
                                                        {"__MACOSX/._good.txt", ""}}));
    const auto files = files_below(path);
    REQUIRE_MESSAGE(files, (files ? "" : files.error().message));
    CHECK(files->files ==
          std::vector<fs::path>{path / "Kl\u00E4nge.txt", path / "a/back.txt", path / "good.txt"});
    CHECK(*files->access.bytes(path / "good.txt", 9) == "1\n");
    CHECK(*files->access.bytes(path / "a/back.txt", 9) == "2\n");
    CHECK(files->access.is_there(path / "good.txt"));
    CHECK_FALSE(files->access.is_there(path / "secret.wav"));
    const std::string at = path.string() + ": ";
    const std::string outside = ": expected a name inside of the zip file";
    CHECK(
        files->left_out ==
        std::vector<std::string>{
            at + "\"secret.wav\": is encrypted: expected a zip file without a password",
            at + "\"link.wav\": a link is not followed",
            at + "\"other.wav\": is packed by method 14 of zip: expected stored or deflated files",
            at + "\"../out.wav\"" + outside, at + "\"a/../../out.wav\"" + outside,
            at + "\"/root.wav\"" + outside, at + "\"C:/drive.wav\"" + outside,
            at + "\"line\\u000aend\"" + outside, at + "\"good.txt\": is there twice"});
}

TEST_CASE("zip: what is damaged is refused in one sentence wherever it is cut or changed") {
    const TemporaryFolder folder;
    const std::string whole = zip_of({{"a.txt", some_bytes(4000)}, {"b.txt", "1\n2\n3\n", false}});
    std::size_t refused = 0;
    for (std::size_t size = 0; size < whole.size(); size += 7) {
        const fs::path path = folder.write("cut.zip", whole.substr(0, size));
        CHECK(fault_of(path) == path.string() + ": is damaged: expected a whole zip file");
    }
    for (std::size_t at = 0; at < whole.size(); at += 3) {
        std::string changed = whole;
        changed[at] = static_cast<char>(changed[at] ^ 0x55);
        const fs::path path = folder.write("changed.zip", changed);
        const auto zip = open_zip_file(path);
        if (!zip) {
            ++refused;
            continue;
        }
        for (const ZipEntry& entry : zip->entries) {
            const auto bytes = unpacked(*zip, entry, 5000);
            // A sum that holds is of the bytes that were packed.
            if (bytes) CHECK((*bytes == some_bytes(4000) || *bytes == "1\n2\n3\n"));
            if (!bytes) ++refused;
        }
    }
    CHECK(refused > whole.size() / 6);
    ZipMember wrong{"a.txt", "1\n2\n"};
    wrong.said_check_sum = 1;
    const auto zip = open_zip_file(folder.write("sum.zip", zip_of({wrong})));
    REQUIRE(zip);
    CHECK(unpacked(*zip, zip->entries[0], 9).error().message ==
          (folder.path / "sum.zip").string() +
              "/a.txt: is damaged: it is not what the zip file says of it");
}

TEST_CASE("zip: a bomb is refused at once, by what it says and by what it is") {
    const TemporaryFolder folder;
    const std::string zeros(100'000'000, '\0');
    ZipMember modest{"modest.txt", zeros};
    modest.said_bytes = 1000;
    ZipMember huge{"huge.txt", "0"};
    huge.said_bytes = ~std::uint64_t{0};
    std::vector<ZipMember> many(3, {"", "0"});
    for (std::size_t k = 0; k < many.size(); ++k) {
        many[k].name = std::to_string(k);
        many[k].said_bytes = std::uint64_t{1} << 31;
    }
    const fs::path lying = folder.write("lying.zip", zip_of({modest}));
    const fs::path plain = folder.write("plain.zip", zip_of({{"zeros.txt", zeros}}));
    const fs::path endless = folder.write("endless.zip", zip_of({huge, huge}, true));
    const fs::path several = folder.write("several.zip", zip_of(many));
    std::string count = zip_of({{"a", "0"}}, true);
    const std::size_t end = count.find("PK\x06\x06");
    count.replace(end + 32, 8, std::string("\0\0\0\0\x01\0\0\0", 8));
    const fs::path counted = folder.write("counted.zip", count);
    const long before_kb = most_memory_kb();
    const auto begun = std::chrono::steady_clock::now();
    CHECK(fault_of(plain) == plain.string() +
                                 ": expected files of at most 67,108,864 bytes in all, got "
                                 "100,000,000");
    CHECK(fault_of(endless).find("expected files of at most 67,108,864 bytes in all") !=
          std::string::npos);
    CHECK(fault_of(several).find("expected files of at most") != std::string::npos);
    CHECK(fault_of(counted) ==
          counted.string() + ": expected at most 100,000 files and folders in all");
    const auto zip = open_zip_file(lying);
    REQUIRE(zip);
    CHECK_FALSE(unpacked(*zip, zip->entries[0], 1'000'000));
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begun;
    CHECK(taken.count() < 0.1);
    CHECK(most_memory_kb() - before_kb < 10'000);
}

}  // namespace zip_file_test
