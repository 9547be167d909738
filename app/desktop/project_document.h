#pragma once

#include <QObject>
#include <QUndoStack>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/desktop/undo_commands.h"
#include "core/error.h"
#include "percollect/graph.h"
#include "specs/project_store.h"
#include "specs/trace.h"

namespace desktop {

/// The project that the window shows: a working copy in memory, and the store that it came from.
///
/// Saving is a decision: edits change the working copy through the undo stack, save() writes all of them as one
/// transaction. So undo reaches back over everything since the file was opened, nothing half-finished is in the file
/// for others to read, and closing without saving really leaves it as it was. Verdicts of acceptance runs are records,
/// not edits: they are stored at once and cannot be undone.
class ProjectDocument final : public QObject {
  Q_OBJECT

 public:
  explicit ProjectDocument(QObject* parent = nullptr);

  /// Shows another project; unsaved changes are dropped. Throws InputError and keeps the old one if it cannot be read.
  void open(const std::filesystem::path& file);
  /// Reads the file again, dropping what was not saved.
  void reload();
  void close();

  [[nodiscard]] bool isOpen() const noexcept { return store_.has_value(); }
  [[nodiscard]] std::filesystem::path file() const;
  /// Where a report of this name goes. A time in it loses its colons, which some systems do not allow.
  [[nodiscard]] std::filesystem::path reportFile(std::string name) const;
  [[nodiscard]] std::filesystem::path folder() const;
  [[nodiscard]] bool readOnly() const { return store_ && store_->readOnly(); }
  [[nodiscard]] bool modified() const { return !undo_stack_.isClean(); }
  /// Another program has written to the file since it was read.
  [[nodiscard]] bool changedElsewhere() const;

  /// All or nothing. Throws InputError; the working copy and its undo steps stay.
  void save();

  [[nodiscard]] QUndoStack& undoStack() noexcept { return undo_stack_; }
  [[nodiscard]] const specs::Specification& specification() const noexcept { return specification_; }
  [[nodiscard]] const cepra::Table& table() const noexcept { return specification_.cepra; }
  [[nodiscard]] const percollect::Graph& graph() const noexcept { return graph_; }
  [[nodiscard]] const specs::LinkIndex& links() const noexcept { return links_; }
  [[nodiscard]] std::optional<AnyItem> item(const std::string& id) const;
  [[nodiscard]] std::vector<specs::Change> history(const std::string& id) const;
  /// Rows with the node on their path or among their causes.
  [[nodiscard]] std::vector<std::size_t> rowsWithNode(const std::string& node_id) const;
  [[nodiscard]] std::vector<std::string> requirementsOf(const std::string& row_key) const;

  /// One undo step each. An empty list of changes is none.
  void editRows(std::vector<RowChange> changes, const QString& text);
  void editField(const std::string& id, const std::string& field, const std::string& text);  // throws InputError
  void addItem(AnyItem item, const std::vector<std::string>& origins, const std::vector<std::string>& followers = {});
  void removeItem(const std::string& id);
  void setLinked(const std::string& from, const std::string& to, bool linked);  // throws InputError

  /// What a diagnosis proposes is a record, like a verdict: stored at once, not to be undone. Returns how many are new.
  std::size_t addProposals(const std::vector<specs::Proposal>& proposals);
  /// A decision is one undo step, with what it writes. Throw InputError if it cannot be taken.
  void acceptProposal(const std::string& id);
  void dismissProposal(const std::string& id, const std::string& reason);

  /// Somebody has looked at a suspect link.
  void markReviewed(const std::string& from, const std::string& to);

  /// A free shown id for something new that follows from a row or an item.
  [[nodiscard]] std::string proposeId(const std::string& origin) const;

  [[nodiscard]] specs::ProjectStore& store() { return *store_; }
  /// The newest run of a test with everything that its report shows; nothing if it never ran.
  [[nodiscard]] std::optional<specs::TestVerdict> lastEvaluation(const std::string& test_id) const;
  /// Newest verdicts again from the file, after a run was stored.
  void refreshVerdicts();

  /// For undo commands only.
  void apply(const std::vector<RowChange>& changes);
  void apply(const SpecificationChange& change);
  void apply(const specs::Proposal& proposal);

 signals:
  void reset();  ///< everything is new
  void rowsChanged(const std::vector<std::size_t>& rows);
  void itemEdited(const QString& id);  ///< a field of one item, its id the same as before
  void specificationChanged();         ///< items or links came or went
  void verdictsChanged();
  void proposalsChanged();
  void modifiedChanged(bool modified);

 private:
  [[nodiscard]] const specs::Proposal& proposal(const std::string& id) const;
  [[nodiscard]] core::Place place(const std::string& item) const;

  std::optional<specs::ProjectStore> store_;
  int data_version_ = 0;
  specs::Specification specification_;
  percollect::Graph graph_;
  specs::LinkIndex links_;
  QUndoStack undo_stack_;
};

}  // namespace desktop
