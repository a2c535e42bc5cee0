// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

// Guards against half-written outputs: a failure, or a program that ends early, must leave an
// earlier result as it was and no litter beside it.

#include "taut/files/file.hpp"

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "support/errors.hpp"
#include "support/scratch.hpp"

namespace taut {
namespace {

using test::bytes_of;
using test::put_bytes;
using test::ScratchDirectory;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Files of more than so many bytes cannot be written while it lives: a full disk.
class FullDisk {
public:
    explicit FullDisk(rlim_t bytes) : m_handler(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &m_before);
        const rlimit limit{.rlim_cur = bytes, .rlim_max = m_before.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FullDisk() {
        setrlimit(RLIMIT_FSIZE, &m_before);
        std::signal(SIGXFSZ, m_handler);
    }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;
    FullDisk(FullDisk&&) = delete;
    FullDisk& operator=(FullDisk&&) = delete;

private:
    void (*m_handler)(int);
    rlimit m_before{};
};

std::string output_error_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const OutputError& error) {
        return error.what();
    }
    ADD_FAILURE() << "expected an OutputError";
    return {};
}

TEST(AtomicFile, ReplacesTheTargetOnlyWhenItIsCommitted) {
    const ScratchDirectory scratch;
    put_bytes(scratch / "out", "before");
    for (const bool is_committed : {false, true}) {
        {
            AtomicFile file(scratch / "out");
            put_bytes(file.temporary(), "after");
            EXPECT_EQ(bytes_of(scratch / "out"), "before");
            if (is_committed) {
                file.commit();
            }
        }
        EXPECT_EQ(bytes_of(scratch / "out"), is_committed ? "after" : "before");
        EXPECT_THAT(scratch.files(), ElementsAre("out"));
    }
}

TEST(AtomicFile, FollowsALinkToWhatIsNotThereYet) {
    const ScratchDirectory scratch;
    std::filesystem::create_directory(scratch / "inner");
    std::filesystem::create_symlink("inner/file", scratch / "link");
    write_file(scratch / "link", "content");
    EXPECT_TRUE(std::filesystem::is_symlink(scratch / "link"));
    EXPECT_EQ(bytes_of(scratch / "inner/file"), "content");
    write_file(scratch / "link", "again");
    EXPECT_TRUE(std::filesystem::is_symlink(scratch / "link"));
    EXPECT_EQ(bytes_of(scratch / "inner/file"), "again");
}

TEST(AtomicFile, LeavesALinkThatLeadsNowhere) {
    const ScratchDirectory scratch;
    std::filesystem::create_symlink("nowhere/file", scratch / "link");
    std::filesystem::create_symlink("loop", scratch / "loop");
    EXPECT_THROW(write_file(scratch / "link", "content"), OutputError);
    EXPECT_THROW(write_file(scratch / "loop", "content"), OutputError);
    EXPECT_TRUE(std::filesystem::is_symlink(scratch / "link"));
    EXPECT_TRUE(std::filesystem::is_symlink(scratch / "loop"));
}

TEST(WriteFiles, MakeTheDirectoryThatALinkLeadsToOrLeaveTheLink) {
    const ScratchDirectory scratch;
    put_bytes(scratch / "file", "");
    std::filesystem::create_symlink("file/there", scratch / "bad");
    EXPECT_THROW(write_files(scratch / "bad", {{"a", "content"}}), OutputError);
    EXPECT_TRUE(std::filesystem::is_symlink(scratch / "bad"));
    std::filesystem::create_symlink("there", scratch / "out");
    write_files(scratch / "out", {{"a", "content"}});
    EXPECT_TRUE(std::filesystem::is_symlink(scratch / "out"));
    EXPECT_EQ(bytes_of(scratch / "there/a"), "content");
}

TEST(AtomicFile, TemporaryFilesOfProcessesThatAreNoLongerThereAreFound) {
    const ScratchDirectory scratch;
    const pid_t child = fork();
    if (child == 0) {
        _exit(0);
    }
    waitpid(child, nullptr, 0);  // a number that no process has
    const std::string left = ".out.json." + std::to_string(child) + "-0.tmp";
    put_bytes(scratch / left, "");
    put_bytes(scratch / (".out.json." + std::to_string(getpid()) + "-0.tmp"), "");
    put_bytes(scratch / (".other.json." + std::to_string(child) + "-0.tmp"), "");
    put_bytes(scratch / ".out.json.notes.tmp", "");
    put_bytes(scratch / (".out.json." + std::to_string(child) + "-mine.tmp"), "");
    EXPECT_THAT(left_temporary_files(scratch / "out.json"), ElementsAre(scratch / left));
    std::filesystem::create_symlink("out.json", scratch / "link");
    EXPECT_THAT(left_temporary_files(scratch / "link"), ElementsAre(scratch / left));
    EXPECT_THAT(left_temporary_files(scratch / "nowhere/out.json"), IsEmpty());
}

mode_t mode_of(const std::filesystem::path& path) {
    struct stat status{};
    EXPECT_EQ(stat(path.c_str(), &status), 0);
    return status.st_mode & 07777U;
}

TEST(AtomicFile, HasTheModeOfWhatItReplacesElseThatOfAnyNewFile) {
    const ScratchDirectory scratch;
    write_file(scratch / "ours", "");
    put_bytes(scratch / "any", "");
    EXPECT_EQ(mode_of(scratch / "ours"), mode_of(scratch / "any"));
    std::filesystem::create_symlink("out", scratch / "link");
    for (const mode_t mode : {0600U, 0640U, 0664U, 0755U, 0200U}) {
        put_bytes(scratch / "out", "before");
        ASSERT_EQ(chmod((scratch / "out").c_str(), mode), 0);
        AtomicFile file(scratch / "link");
        EXPECT_EQ(mode_of(file.temporary()), mode);
        put_bytes(file.temporary(), "after");
        file.commit();
        EXPECT_EQ(mode_of(scratch / "out"), mode);
        EXPECT_EQ(bytes_of(scratch / "out"), "after");
        std::filesystem::remove(scratch / "out");
    }
}

TEST(AtomicFile, KeepsOwnerAndGroupWhereItMay) {
    if (getuid() != 0) {
        GTEST_SKIP() << "only the superuser gives files away";
    }
    const ScratchDirectory scratch;
    put_bytes(scratch / "out", "before");
    ASSERT_EQ(chown((scratch / "out").c_str(), 1234, 2345), 0);
    write_file(scratch / "out", "after");
    struct stat status{};
    ASSERT_EQ(stat((scratch / "out").c_str(), &status), 0);
    EXPECT_EQ(status.st_uid, 1234U);
    EXPECT_EQ(status.st_gid, 2345U);
}

TEST(AtomicFile, RefusesWhatIsReadOnlyEvenForTheSuperuser) {
    const ScratchDirectory scratch;
    put_bytes(scratch / "out", "before");
    ASSERT_EQ(chmod((scratch / "out").c_str(), 0444), 0);
    EXPECT_EQ(output_error_of([&] { write_file(scratch / "out", "after"); }),
              (scratch / "out").string() + ": is read-only, expected a file that may be replaced");
    EXPECT_EQ(
        output_error_of([&] { write_files({{scratch / "new", "a"}, {scratch / "out", "after"}}); }),
        (scratch / "out").string() + ": is read-only, expected a file that may be replaced");
    EXPECT_EQ(bytes_of(scratch / "out"), "before");
    EXPECT_THAT(scratch.files(), ElementsAre("out"));
}

TEST(AtomicFile, RefusesWhatCannotBecomeAFile) {
    const ScratchDirectory scratch;
    const std::string target = (scratch / "nowhere/out").string();
    EXPECT_EQ(output_error_of([&] { AtomicFile file(target); }),
              target + ": cannot be written: No such file or directory");
    EXPECT_EQ(output_error_of([&] { AtomicFile file(scratch.path()); }),
              scratch.path().string() + ": is a directory, expected a file");
    EXPECT_THAT(output_error_of([] { AtomicFile file("/dev/null"); }), HasSubstr("is a device"));
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
    EXPECT_THROW(AtomicFile(""), OutputError);
}

TEST(WriteFile, LeavesAnExistingFileAndNoTemporaryWhereTheDiskIsFull) {
    const ScratchDirectory scratch;
    put_bytes(scratch / "out", "before");
    const std::string message = [&] {
        const FullDisk full(100);
        return output_error_of([&] { write_file(scratch / "out", std::string(100'000, 'x')); });
    }();
    EXPECT_THAT(message, HasSubstr("out: cannot be written: File too large"));
    EXPECT_EQ(bytes_of(scratch / "out"), "before");
    EXPECT_THAT(scratch.files(), ElementsAre("out"));
}

TEST(WriteFiles, WritesAllIntoADirectoryThatItMakesOrMakesNone) {
    const ScratchDirectory scratch;
    {
        const FullDisk full(100);
        EXPECT_THROW(write_files(scratch / "a/b", {{"one", std::string(100'000, 'x')}}),
                     OutputError);
    }
    EXPECT_THAT(scratch.files(), IsEmpty());
    write_files(scratch / "a/b", {{"one", "1"}, {"two", "2"}});
    EXPECT_EQ(bytes_of(scratch / "a/b/one"), "1");
    EXPECT_EQ(bytes_of(scratch / "a/b/two"), "2");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(scratch / "a/b"), {}), 2);
    EXPECT_THAT(output_error_of([&] { write_files(scratch / "a/b/one", {{"c", "1"}}); }),
                HasSubstr("cannot be made as a directory"));
    EXPECT_EQ(bytes_of(scratch / "a/b/one"), "1");
}

TEST(WriteFiles, RefusesNamesThatLeadOutOfTheDirectoryOrComeTwice) {
    const ScratchDirectory scratch;
    for (const char* name : {"", ".", "..", "../one", "/tmp/one", "a/one"}) {
        EXPECT_THROW(write_files(scratch.path(), {{name, "1"}}), std::invalid_argument) << name;
    }
    EXPECT_THROW(write_files({{scratch / "one", "1"}, {scratch / "./one", "2"}}),
                 std::invalid_argument);
    EXPECT_THAT(scratch.files(), IsEmpty());
}

TEST(WriteFiles, WritesAllPathsOrNone) {
    const ScratchDirectory scratch;
    std::filesystem::create_directory(scratch / "a");
    put_bytes(scratch / "one", "before");
    put_bytes(scratch / "a/two", "before");
    {
        const FullDisk full(100);
        EXPECT_THROW(write_files({{scratch / "one", "after"},
                                  {scratch / "a/two", std::string(100'000, 'x')}}),
                     OutputError);
    }
    EXPECT_EQ(bytes_of(scratch / "one"), "before");
    EXPECT_EQ(bytes_of(scratch / "a/two"), "before");
    EXPECT_THAT(scratch.files(), ElementsAre("a", "one"));
    write_files({{scratch / "one", "after"}, {scratch / "a/two", "after"}});
    EXPECT_EQ(bytes_of(scratch / "one"), "after");
    EXPECT_EQ(bytes_of(scratch / "a/two"), "after");
}

TEST(IsSameFile, KnowsAFileByAnyNameWhetherItIsThereOrNot) {
    const ScratchDirectory scratch;
    put_bytes(scratch / "one", "");
    std::filesystem::create_symlink("one", scratch / "link");
    std::filesystem::create_hard_link(scratch / "one", scratch / "hard");
    EXPECT_TRUE(is_same_file(scratch / "one", scratch / "link"));
    EXPECT_TRUE(is_same_file(scratch / "one", scratch / "hard"));
    EXPECT_FALSE(is_same_file(scratch / "one", scratch / "two"));
    EXPECT_TRUE(is_same_file(scratch / "two", scratch / "./two"));
    EXPECT_TRUE(is_same_file("two", "./two"));
    std::filesystem::create_symlink("new", scratch / "to_new");
    EXPECT_TRUE(is_same_file(scratch / "new", scratch / "to_new"));
    EXPECT_FALSE(is_same_file("two", "./three"));
    EXPECT_FALSE(is_same_file("", ""));
}

TEST(ReadFile, GivesEveryByte) {
    const ScratchDirectory scratch;
    std::string bytes;
    for (int i = 0; i < 200'000; ++i) {
        bytes += static_cast<char>(i * 7);
    }
    put_bytes(scratch / "in", bytes);
    EXPECT_EQ(read_file(scratch / "in"), bytes);
}

TEST(ReadFile, RefusesWhatIsNoFile) {
    EXPECT_EQ(test::input_error_of([] { return read_file("/nowhere/in"); }),
              "/nowhere/in: cannot be read: No such file or directory");
    EXPECT_EQ(test::input_error_of([] { return read_file("/tmp"); }),
              "/tmp: is a directory, expected a file");
}

}  // namespace
}  // namespace taut
