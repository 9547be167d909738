#include "core/new_folder.h"

#include <cerrno>
#include <cstdlib>
#include <system_error>

#include "core/error.h"

namespace core {

namespace fs = std::filesystem;

namespace {

InputError cannotWrite(const fs::path& folder, const std::error_code& code) {
  return {{.file = folder},
          "cannot be written: " + code.message() + ".",
          "Check that its parent folder exists and that you may write there."};
}

/// Absolute and without a slash at its end.
fs::path wholeName(const fs::path& folder) {
  const auto whole = fs::absolute(folder).lexically_normal();
  return whole.has_filename() ? whole : whole.parent_path();
}

}  // namespace

NewFolder::NewFolder(fs::path target) : target_(std::move(target)) {
  if (fs::exists(target_) && (!fs::is_directory(target_) || !fs::is_empty(target_))) {
    throw InputError({.file = target_}, "exists and is not an empty folder.", "Name a new folder for the result.");
  }
  std::string name = wholeName(target_).string() + ".part-XXXXXX";
  if (::mkdtemp(name.data()) == nullptr) throw cannotWrite(target_, {errno, std::generic_category()});
  part_ = name;
}

NewFolder::~NewFolder() {
  std::error_code ignored;
  fs::remove_all(part_, ignored);
}

void NewFolder::appear() {
  std::error_code code;
  fs::permissions(part_,
                  fs::perms::others_read | fs::perms::others_exec | fs::perms::group_read | fs::perms::group_exec,
                  fs::perm_options::add, code);
  if (!code) fs::rename(part_, wholeName(target_), code);  // takes the place of an empty folder, of no other
  if (code) throw cannotWrite(target_, code);
}

}  // namespace core
