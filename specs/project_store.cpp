#include "specs/project_store.h"

#include "specs/connection.h"

namespace specs {

ProjectStore::ProjectStore(std::unique_ptr<Connection> connection) : connection_(std::move(connection)) {}
ProjectStore::ProjectStore(ProjectStore&&) noexcept = default;
ProjectStore& ProjectStore::operator=(ProjectStore&&) noexcept = default;
ProjectStore::~ProjectStore() = default;

ProjectStore ProjectStore::create(const std::filesystem::path& file) {
  return ProjectStore(std::make_unique<Connection>(file, Opening::Create));
}

ProjectStore ProjectStore::open(const std::filesystem::path& file, Access access) {
  return ProjectStore(
      std::make_unique<Connection>(file, access == Access::ReadOnly ? Opening::ReadOnly : Opening::ReadWrite));
}

const std::filesystem::path& ProjectStore::file() const noexcept { return connection_->file; }

std::filesystem::path ProjectStore::folder() const {
  return std::filesystem::absolute(connection_->file).parent_path();
}

bool ProjectStore::readOnly() const noexcept { return connection_->read_only; }

void ProjectStore::setPatience(std::chrono::milliseconds patience) { connection_->setPatience(patience); }

int ProjectStore::dataVersion() const {
  return static_cast<int>(connection_->integer("PRAGMA data_version", {}).value());
}

void ProjectStore::inOneAction(const std::function<void()>& changes) { connection_->action(changes); }

Specification ProjectStore::specification() const {
  Specification result;
  connection_->snapshot([&] {
    result.project = connection_->file.stem().string();
    result.requirements = all<Requirement>();
    result.tests = all<AcceptanceTest>();
    result.experiment_data = all<ExperimentData>();
    result.reference_data = all<ReferenceData>();
    result.links = links();
    result.cepra = cepra();
    result.graph = graphImport();
    result.verdicts = latestVerdicts();
    result.proposals = proposals();
  });
  return result;
}

}  // namespace specs
