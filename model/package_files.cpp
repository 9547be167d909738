#include "model/package_files.h"

#include <cctype>

#include "core/error.h"

namespace model {

void copyReferenced(const Experiment& experiment, const std::filesystem::path& folder) {
  for (const Sample& sample : experiment.samples) {
    for (const std::filesystem::path& file : filesOf(experiment, sample)) {
      if (file == experiment.file || file == sample.measurements) continue;
      const auto place = file.lexically_normal().lexically_relative(experiment.folder().lexically_normal());
      if (place.empty() || *place.begin() == "..") {
        throw core::InputError({.file = experiment.file, .item = "sample '" + sample.id + "'"},
                               "refers to " + file.string() + ", which lies outside the package.",
                               "Copy the file into the package: the simulated one takes its files along.");
      }
      std::filesystem::create_directories((folder / place).parent_path());
      std::filesystem::copy_file(file, folder / place, std::filesystem::copy_options::overwrite_existing);
    }
  }
}

std::string fileNameOf(std::string id) {
  for (char& c : id) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_' || c == '.';
    if (!plain) c = '_';
  }
  return id;
}

}  // namespace model
