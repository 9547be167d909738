#include "app/desktop/undo_commands.h"

#include "app/desktop/project_document.h"

namespace desktop {

EditRows::EditRows(ProjectDocument& document, std::vector<RowChange> changes, const QString& text)
    : QUndoCommand(text), document_(document), changes_(std::move(changes)) {}

void EditRows::undo() {
  std::vector<RowChange> reversed;
  for (const RowChange& change : changes_) reversed.push_back({change.row, change.after, change.before});
  document_.apply(reversed);
}

void EditRows::redo() { document_.apply(changes_); }

DecideProposal::DecideProposal(ProjectDocument& document, specs::Proposal before, specs::Proposal after)
    : QUndoCommand(
          QObject::tr("%1 proposal %2")
              .arg(after.state == specs::ProposalState::Accepted ? QObject::tr("accept") : QObject::tr("dismiss"),
                   QString::fromStdString(after.id))),
      document_(document),
      before_(std::move(before)),
      after_(std::move(after)) {}

void DecideProposal::undo() { document_.apply(before_); }

void DecideProposal::redo() { document_.apply(after_); }

EditSpecification::EditSpecification(ProjectDocument& document, SpecificationChange change, const QString& text,
                                     const std::string& field)
    : QUndoCommand(text), document_(document), change_(std::move(change)), field_(field) {}

int EditSpecification::id() const { return field_.empty() ? -1 : 1; }

bool EditSpecification::mergeWith(const QUndoCommand* next) {
  const auto* other = dynamic_cast<const EditSpecification*>(next);
  if (!other || other->field_ != field_ || change_.added.size() != 1 || other->change_.removed.size() != 1)
    return false;
  if (base(change_.added[0]).uid != base(other->change_.removed[0]).uid) return false;
  change_.added = other->change_.added;
  if (change_.added == change_.removed) setObsolete(true);  // typed back to where it began
  return true;
}

void EditSpecification::undo() { document_.apply(change_.reversed()); }

void EditSpecification::redo() { document_.apply(change_); }

}  // namespace desktop
