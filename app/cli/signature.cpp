#include "app/cli/signature.h"

#include <array>
#include <cstdlib>
#include <ctime>
#include <pwd.h>
#include <unistd.h>

namespace app {

namespace {

std::string loginName() {
  for (const char* variable : {"FIDELIS_AUTHOR", "USER", "LOGNAME"}) {
    const char* value = std::getenv(variable);
    if (value && *value) return value;
  }
  const passwd* entry = ::getpwuid(::getuid());
  return entry ? entry->pw_name : "unknown";
}

std::string now() {
  std::time_t seconds = std::time(nullptr);
  if (const char* fixed = std::getenv("SOURCE_DATE_EPOCH")) seconds = std::strtoll(fixed, nullptr, 10);
  std::tm utc{};
  ::gmtime_r(&seconds, &utc);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text.data();
}

}  // namespace

specs::Signature signatureOf(const std::string& author) {
  return {.who = author.empty() ? loginName() : author, .when = now()};
}

}  // namespace app
