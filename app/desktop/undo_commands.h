#pragma once

#include <QUndoCommand>
#include <string>
#include <vector>

#include "app/desktop/any_item.h"
#include "cepra/table.h"
#include "specs/proposals.h"

namespace desktop {

class ProjectDocument;

/// One row of the relevance table, before and after.
struct RowChange {
  std::size_t row;
  cepra::Row before;
  cepra::Row after;
};

/// What one action does to the specification. An edited item is removed and added again under the same uid.
struct SpecificationChange {
  std::vector<AnyItem> removed;
  std::vector<AnyItem> added;
  std::vector<specs::Link> unlinked;
  std::vector<specs::Link> linked;

  [[nodiscard]] SpecificationChange reversed() const { return {added, removed, linked, unlinked}; }
};

/// Scores, rationales and notes of one or many rows: typing, pasting, clearing, filling down.
class EditRows final : public QUndoCommand {
 public:
  EditRows(ProjectDocument& document, std::vector<RowChange> changes, const QString& text);
  void undo() override;
  void redo() override;

 private:
  ProjectDocument& document_;
  std::vector<RowChange> changes_;
};

/// What a person decided about a proposal; what it writes are steps beside this one.
class DecideProposal final : public QUndoCommand {
 public:
  DecideProposal(ProjectDocument& document, specs::Proposal before, specs::Proposal after);
  void undo() override;
  void redo() override;

 private:
  ProjectDocument& document_;
  specs::Proposal before_;
  specs::Proposal after_;
};

/// Items and links. Typing on in the same field of the same item is one step (`field` not empty).
class EditSpecification final : public QUndoCommand {
 public:
  EditSpecification(ProjectDocument& document, SpecificationChange change, const QString& text,
                    const std::string& field = "");
  [[nodiscard]] int id() const override;
  bool mergeWith(const QUndoCommand* next) override;
  void undo() override;
  void redo() override;

 private:
  ProjectDocument& document_;
  SpecificationChange change_;
  std::string field_;
};

}  // namespace desktop
