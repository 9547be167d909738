#include "core/file.h"

#include <array>
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.h"
#include "tests/support/paths.h"

namespace {

using test_support::TemporaryFolder;
using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(WriteFile, ReplacesTheWholeFileAndLeavesNothingBeside) {
  const TemporaryFolder folder;
  const auto file = folder.write("a.txt", "a longer text that was there before");
  core::writeFile(file, "new");
  EXPECT_EQ(core::readFile(file), "new");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(WriteFile, CompressedFileReadsBackTheSameAndTheBytesRepeat) {
  const TemporaryFolder folder;
  core::writeFile(folder / "a.gz", "text");
  core::writeFile(folder / "b.gz", "text");
  EXPECT_EQ(core::readFile(folder / "a.gz"), "text");
  EXPECT_EQ(core::sha256OfFile(folder / "a.gz"), core::sha256OfFile(folder / "b.gz"));
}

// A result sent to /dev/null must not turn the device into a file. A pipe stands in for it here: a failing test with
// the real device would break the machine.
TEST(WriteFile, DeviceIsWrittenToAndNotReplaced) {
  const TemporaryFolder folder;
  const auto pipe = folder / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const int reader = ::open(pipe.c_str(), O_RDWR | O_NONBLOCK);
  ASSERT_GE(reader, 0);
  core::writeFile(pipe, "through");
  std::array<char, 16> buffer{};
  EXPECT_EQ(::read(reader, buffer.data(), buffer.size()), 7);
  EXPECT_STREQ(buffer.data(), "through");
  ::close(reader);
  EXPECT_TRUE(std::filesystem::is_fifo(pipe));
}

TEST(WriteFile, SymbolicLinkStaysALink) {
  const TemporaryFolder folder;
  const auto file = folder.write("real.txt", "old");
  const auto link = folder / "link.txt";
  std::filesystem::create_symlink("real.txt", link);
  core::writeFile(link, "new");
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  EXPECT_EQ(core::readFile(file), "new");
}

TEST(WriteFile, MissingFolderIsToldAndNothingIsMade) {
  const TemporaryFolder folder;
  const auto target = folder.path() / "no" / "file.txt";
  EXPECT_THAT([&] { core::writeFile(target, "x"); },
              ThrowsMessage<core::InputError>(HasSubstr("file.txt: cannot be written: No such file or directory")));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(WriteFile, FolderIsNoTarget) {
  const TemporaryFolder folder;
  EXPECT_THAT([&] { core::writeFile(folder.path(), "x"); },
              ThrowsMessage<core::InputError>(HasSubstr("cannot be written")));
}

}  // namespace
