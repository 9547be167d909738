#include "core/json_object.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/support/paths.h"

namespace {

std::string messageOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const core::InputError& error) {
    return error.what();
  }
  return "(no error)";
}

TEST(JsonObject, UnknownKeyNamesFilePointerAndNearestKnownKey) {
  const auto value = nlohmann::json::parse(R"({"reciever": {}})");
  core::JsonObject object(value, "profile.json", "/sensor");
  (void)object.has("receiver");
  EXPECT_EQ(messageOf([&] { object.finish(); }),
            "profile.json, /sensor/reciever: is an unknown key.\n"
            "  Did you mean 'receiver'? Keys of your own begin with 'x-'.");
}

TEST(JsonObject, KeysThatBeginWithXAreTheUsersOwn) {
  const auto value = nlohmann::json::parse(R"({"x-note": 1})");
  const core::JsonObject object(value, "profile.json");
  EXPECT_NO_THROW(object.finish());
}

TEST(JsonObject, NumberOutsideItsBoundsSaysBoth) {
  const auto value = nlohmann::json::parse(R"({"reflectivity": 1.5})");
  core::JsonObject object(value, "e.json");
  const std::string message = messageOf([&] { (void)object.number("reflectivity", {.min = 0.0, .max = 1.0}); });
  EXPECT_NE(message.find("/reflectivity: is 1.5; it must be at least 0 and at most 1."), std::string::npos) << message;
}

TEST(JsonObject, NullIsAbsentAndNotZero) {
  const auto value = nlohmann::json::parse(R"({"visibility_m": null})");
  core::JsonObject object(value, "e.json");
  EXPECT_EQ(object.optionalNumber("visibility_m"), std::nullopt);
  EXPECT_FALSE(object.has("visibility_m"));
}

TEST(JsonObject, TextForANumberSaysWhatWasExpected) {
  const auto value = nlohmann::json::parse(R"({"frames": "ten"})");
  core::JsonObject object(value, "e.json");
  EXPECT_NE(messageOf([&] { (void)object.number("frames"); }).find("is a string; a number was expected"),
            std::string::npos);
}

TEST(JsonObject, NewerVersionIsRefusedWithTheWayOut) {
  const auto value = nlohmann::json::parse(R"({"format": "fidelis-sensor", "version": 2})");
  core::JsonObject object(value, "s.json");
  EXPECT_NE(messageOf([&] { object.expectFormat("fidelis-sensor", 1); }).find("Use a newer Fidelis."),
            std::string::npos);
}

TEST(ReadJson, DoubledKeyIsAnErrorAndNotSilentlyTheLastOne) {
  const test_support::TemporaryFolder folder;
  const auto file = folder.write("twice.json", "{\"a\": 1,\n \"a\": 2}");
  EXPECT_NE(messageOf([&] { (void)core::readJson(file); }).find("the key 'a' stands twice"), std::string::npos);
}

TEST(ReadJson, SyntaxErrorNamesItsLine) {
  const test_support::TemporaryFolder folder;
  const auto file = folder.write("broken.json", "{\n\"a\": 1,\n\"b\": }\n");
  EXPECT_NE(messageOf([&] { (void)core::readJson(file); }).find("broken.json:3:"), std::string::npos);
}

}  // namespace
