#include "app/desktop/project_document.h"

#include <QUuid>
#include <algorithm>

#include "app/cli/signature.h"
#include "proposals/decide.h"
#include "specs/lists.h"
#include "specs/shown_id.h"

namespace desktop {

namespace {

QString shown(specs::Kind kind) {
  return QString::fromUtf8(specs::name(kind).data(), qsizetype(specs::name(kind).size()));
}

bool sameEnds(const specs::Link& a, const specs::Link& b) { return a.from == b.from && a.to == b.to; }

}  // namespace

ProjectDocument::ProjectDocument(QObject* parent) : QObject(parent), links_(specs::Specification{}) {
  connect(&undo_stack_, &QUndoStack::cleanChanged, this, [this](bool clean) { emit modifiedChanged(!clean); });
}

void ProjectDocument::open(const std::filesystem::path& file) {
  specs::ProjectStore store = specs::ProjectStore::open(file);
  // Read everything before the old project is given up.
  specs::Specification specification = store.specification();
  auto graph = store.graph();
  store_.emplace(std::move(store));
  data_version_ = store_->dataVersion();
  specification_ = std::move(specification);
  graph_ = graph ? std::move(*graph) : percollect::Graph();
  links_ = specs::LinkIndex(specification_);
  undo_stack_.clear();
  emit reset();
}

void ProjectDocument::reload() { open(file()); }

void ProjectDocument::close() {
  store_.reset();
  specification_ = {};
  graph_ = {};
  links_ = specs::LinkIndex(specification_);
  undo_stack_.clear();
  emit reset();
}

std::filesystem::path ProjectDocument::file() const { return store_ ? store_->file() : std::filesystem::path(); }

std::filesystem::path ProjectDocument::reportFile(std::string name) const {
  std::erase(name, ':');
  return folder() / "reports" / name;
}

std::filesystem::path ProjectDocument::folder() const { return store_ ? store_->folder() : std::filesystem::path(); }

bool ProjectDocument::changedElsewhere() const { return store_ && store_->dataVersion() != data_version_; }

void ProjectDocument::save() {
  if (!store_) return;
  const specs::Signature by = app::signatureOf("");
  store_->inOneAction([&] {
    specs::applyLists(*store_, {.specification = specification_}, true, by);
    for (const specs::Proposal& each : specification_.proposals) store_->decide(each, by);
  });
  data_version_ = store_->dataVersion();
  undo_stack_.setClean();
}

core::Place ProjectDocument::place(const std::string& item) const { return {.file = file(), .item = item}; }

std::optional<AnyItem> ProjectDocument::item(const std::string& id) const {
  for (AnyItem& candidate : itemsOf(specification_)) {
    if (base(candidate).id == id) return std::move(candidate);
  }
  return std::nullopt;
}

std::vector<specs::Change> ProjectDocument::history(const std::string& id) const {
  // An item that was added or renamed since the last save has no history under this id yet.
  if (!store_ || !store_->reference(id)) return {};
  return store_->history(id);
}

std::vector<std::size_t> ProjectDocument::rowsWithNode(const std::string& node_id) const {
  const auto is_node = [&](const auto& node) { return node.id == node_id; };
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < table().rows.size(); ++i) {
    const cepra::Row& row = table().rows[i];
    if (std::ranges::any_of(row.effects, is_node) || std::ranges::any_of(row.causes, is_node)) found.push_back(i);
  }
  return found;
}

std::vector<std::string> ProjectDocument::requirementsOf(const std::string& row_key) const {
  std::vector<std::string> ids;
  for (const specs::Link& link : links_.followersOf(row_key)) ids.push_back(link.to);
  return ids;
}

void ProjectDocument::editRows(std::vector<RowChange> changes, const QString& text) {
  std::erase_if(changes, [](const RowChange& change) { return change.before == change.after; });
  if (!changes.empty()) undo_stack_.push(new EditRows(*this, std::move(changes), text));
}

void ProjectDocument::editField(const std::string& id, const std::string& field, const std::string& text) {
  const auto before = item(id);
  if (!before) return;
  AnyItem after = *before;
  if (const std::string problem = setField(after, field, text); !problem.empty()) {
    throw core::InputError(place(id + ", " + field), problem + ".", "The field keeps what it had.");
  }
  if (after == *before) return;
  SpecificationChange change{.removed = {*before}, .added = {after}};
  const std::string& new_id = base(after).id;
  if (new_id != id) {
    if (!specs::isShownId(new_id) || links_.find(new_id)) {
      throw core::InputError(
          place(id), "'" + new_id + "' cannot be its id.",
          "Ids are unique and look like RangeError_Fog_2: parts that begin with a capital, then a number.");
    }
    for (const specs::Link& link : specification_.links) {
      if (link.from != id && link.to != id) continue;
      change.unlinked.push_back(link);
      change.linked.push_back({link.from == id ? new_id : link.from, link.to == id ? new_id : link.to, link.suspect});
    }
  }
  undo_stack_.push(new EditSpecification(
      *this, std::move(change), tr("edit %1 of %2").arg(QString::fromStdString(field), QString::fromStdString(id)),
      new_id == id ? field : ""));
}

void ProjectDocument::addItem(AnyItem item, const std::vector<std::string>& origins,
                              const std::vector<std::string>& followers) {
  SpecificationChange change;
  const std::string id = base(item).id;
  // The store keeps a uid that is given and free, so undo and redo before and after saving mean the same item.
  const std::string uid = QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString();
  std::visit([&](auto& it) { it.uid = uid; }, item);
  for (const std::string& origin : origins) change.linked.push_back({origin, id});
  for (const std::string& follower : followers) change.linked.push_back({id, follower});
  const QString text = tr("add %1 %2").arg(shown(kindOf(item)), QString::fromStdString(id));
  change.added = {std::move(item)};
  undo_stack_.push(new EditSpecification(*this, std::move(change), text));
}

void ProjectDocument::removeItem(const std::string& id) {
  const auto found = item(id);
  if (!found) return;
  SpecificationChange change{.removed = {*found}};
  for (const specs::Link& link : specification_.links) {
    if (link.from == id || link.to == id) change.unlinked.push_back(link);
  }
  undo_stack_.push(new EditSpecification(*this, std::move(change), tr("remove %1").arg(QString::fromStdString(id))));
}

void ProjectDocument::setLinked(const std::string& from, const std::string& to, bool linked) {
  const auto& links = specification_.links;
  const auto found = std::ranges::find_if(links, [&](const specs::Link& link) { return sameEnds(link, {from, to}); });
  if (linked == (found != links.end())) return;
  if (!linked) {
    undo_stack_.push(
        new EditSpecification(*this, {.unlinked = {*found}}, tr("unlink %1").arg(QString::fromStdString(to))));
    return;
  }
  const specs::Entry* origin = links_.find(from);
  const specs::Entry* follower = links_.find(to);
  if (!origin || !follower || !specs::mayLink(origin->kind, follower->kind)) {
    throw core::InputError(place(from + " -> " + to), "no such link is possible.",
                           "Links lead from a CEPRA row to a requirement, from it to an acceptance test, and from that "
                           "to experiment and reference data.");
  }
  const auto beyond = links_.allFollowersOf(to);
  if (from == to || std::ranges::find(beyond, from) != beyond.end()) {
    throw core::InputError(place(from + " -> " + to), "the link would close a circle.",
                           from + " follows from " + to + " already; remove a link of that way first.");
  }
  undo_stack_.push(
      new EditSpecification(*this, {.linked = {{from, to}}}, tr("link %1").arg(QString::fromStdString(to))));
}

const specs::Proposal& ProjectDocument::proposal(const std::string& id) const {
  if (const specs::Proposal* found = specs::findProposal(specification_.proposals, id)) return *found;
  throw core::InputError(place(id), "there is no such proposal.", "Read the project again.");
}

std::size_t ProjectDocument::addProposals(const std::vector<specs::Proposal>& proposals) {
  const auto added = store_->addProposals(proposals, app::signatureOf(""));
  auto& all = specification_.proposals;
  all.insert(all.end(), added.begin(), added.end());
  emit proposalsChanged();
  return added.size();
}

void ProjectDocument::acceptProposal(const std::string& id) {
  const specs::Proposal before = proposal(id);
  const specs::Signature by = app::signatureOf("");
  const specs::Proposal decided = proposals::accepted(before, by);
  const cepra::Row* row = before.test ? nullptr : &proposals::rowFor(before, table());
  undo_stack_.beginMacro(tr("accept proposal %1").arg(QString::fromStdString(id)));
  if (row) {
    cepra::Row after = *row;
    after.occurrence = proposals::acceptedScore(before, row->occurrence, by.who);
    editRows({{static_cast<std::size_t>(row - table().rows.data()), *row, after}}, tr("occurrence"));
  } else {
    std::vector<std::string> verified = before.requirements;
    std::erase_if(verified, [&](const std::string& requirement) { return !links_.find(requirement); });
    addItem(proposals::acceptedTest(before, specification_, by.who), verified,
            proposals::dataFor(before, specification_));
  }
  undo_stack_.push(new DecideProposal(*this, before, decided));
  undo_stack_.endMacro();
}

void ProjectDocument::dismissProposal(const std::string& id, const std::string& reason) {
  const specs::Proposal before = proposal(id);
  undo_stack_.push(new DecideProposal(*this, before, proposals::dismissed(before, reason, app::signatureOf(""))));
}

void ProjectDocument::markReviewed(const std::string& from, const std::string& to) {
  undo_stack_.push(new EditSpecification(*this, {.unlinked = {{from, to, true}}, .linked = {{from, to, false}}},
                                         tr("review link to %1").arg(QString::fromStdString(to))));
}

std::string ProjectDocument::proposeId(const std::string& origin) const {
  std::vector<std::string> taken;
  for (const AnyItem& it : itemsOf(specification_)) taken.push_back(base(it).id);
  if (const cepra::Row* row = table().find(origin)) {
    return specs::proposeId(row->phenomenon().title, row->lastEffect().title, taken);
  }
  // Siblings share phenomenon and causes and differ in the number.
  const auto number = origin.rfind('_');
  const std::string stem = number == std::string::npos ? "Requirement" : origin.substr(0, number);
  for (int i = 1;; ++i) {
    std::string id = stem + "_" + std::to_string(i);
    if (std::ranges::find(taken, id) == taken.end()) return id;
  }
}

std::optional<specs::TestVerdict> ProjectDocument::lastEvaluation(const std::string& test_id) const {
  if (!store_) return std::nullopt;
  for (const specs::TestRun& run : store_->latestRuns()) {
    const auto of_test = [&](const specs::TestVerdict& verdict) { return verdict.test == test_id; };
    if (std::ranges::none_of(run.verdicts, of_test)) continue;
    const auto whole = store_->findRun(run.id);
    return *std::ranges::find_if(whole->verdicts, of_test);
  }
  return std::nullopt;
}

void ProjectDocument::refreshVerdicts() {
  specification_.verdicts = store_->latestVerdicts();
  emit verdictsChanged();
}

void ProjectDocument::apply(const std::vector<RowChange>& changes) {
  std::vector<std::size_t> rows;
  for (const RowChange& change : changes) {
    specification_.cepra.rows.at(change.row) = change.after;
    rows.push_back(change.row);
  }
  emit rowsChanged(rows);
}

void ProjectDocument::apply(const specs::Proposal& decided) {
  for (specs::Proposal& each : specification_.proposals) {
    if (each.id == decided.id) each = decided;
  }
  emit proposalsChanged();
}

void ProjectDocument::apply(const SpecificationChange& change) {
  for (const AnyItem& item : change.removed) eraseItem(specification_, base(item).uid);
  for (const AnyItem& item : change.added) insertItem(specification_, item);
  for (const specs::Link& gone : change.unlinked) {
    std::erase_if(specification_.links, [&](const specs::Link& link) { return sameEnds(link, gone); });
  }
  auto& links = specification_.links;
  for (const specs::Link& link : change.linked) links.insert(std::ranges::upper_bound(links, link), link);
  links_ = specs::LinkIndex(specification_);
  const bool edited =
      change.removed.size() == 1 && change.added.size() == 1 && base(change.removed[0]).id == base(change.added[0]).id;
  if (edited) {
    emit itemEdited(QString::fromStdString(base(change.added[0]).id));
  } else {
    emit specificationChanged();
  }
}

}  // namespace desktop
