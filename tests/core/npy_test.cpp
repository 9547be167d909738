#include "core/npy.h"

#include <gtest/gtest.h>

#include "tests/support/paths.h"
#include "tests/support/thrown_message.h"

namespace core {
namespace {

/// Version 1 as NumPy writes it: magic, version, length of the header (little-endian), header, numbers.
std::string npy(const std::string& header, const std::string& numbers) {
  return std::string("\x93NUMPY\x01\x00", 8) + static_cast<char>(header.size()) + '\0' + header + numbers;
}

std::string refusal(const std::string& content) {
  const test_support::TemporaryFolder folder;
  return test_support::thrownMessage([&] { (void)readNpy(folder.write("a.npy", content)); });
}

TEST(Npy, NumbersAreRead) {
  const test_support::TemporaryFolder folder;
  const std::string small("\x01\x00\xff\xff\x00\x01", 6);
  const auto ints = npy("{'descr': '<i2', 'fortran_order': False, 'shape': (3,), }\n", small);
  EXPECT_EQ(readNpy(folder.write("i.npy", ints)), (std::vector<double>{1, -1, 256}));
  const std::string one("\x00\x00\x00\x00\x00\x00\xf0\x3f", 8);  // 1.0 as IEEE 754 double
  const auto doubles = npy("{'descr': '<f8', 'fortran_order': False, 'shape': (1,), }\n", one);
  EXPECT_EQ(readNpy(folder.write("d.npy", doubles)), std::vector<double>{1.0});
}

TEST(Npy, OtherFilesAreRefused) {
  EXPECT_NE(refusal("no").find("is no .npy file"), std::string::npos);
  EXPECT_NE(refusal(npy("{'descr': '<f8', 'shape': (2,), }", "short")).find("as many numbers"), std::string::npos);
  EXPECT_NE(refusal(npy("{'descr': '>f8', 'shape': (1,), }", "12345678")).find("'>f8'"), std::string::npos);
  EXPECT_NE(refusal(npy("{'descr': '<f8', 'shape': (1, 1), }", "12345678")).find("header"), std::string::npos);
  EXPECT_NE(refusal(std::string("\x93NUMPY\x01\x00\xff\x7f", 10)).find("ends within"), std::string::npos);
}

}  // namespace
}  // namespace core
