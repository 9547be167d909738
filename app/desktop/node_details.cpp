#include "app/desktop/node_details.h"

#include <QLocale>
#include <algorithm>
#include <set>

#include "app/desktop/colours.h"
#include "app/desktop/html.h"
#include "cepra/table.h"
#include "percollect/chains.h"

namespace desktop {

namespace {

QString countText(const percollect::ChainCount& count) {
  const QString number = QLocale().toString(qulonglong(count.value));
  return count.saturated ? QObject::tr("more than %1").arg(number) : number;
}

QString nodeLink(const percollect::Node& node) {
  return html::link("node:" + QString::fromStdString(node.id), QString::fromStdString(node.title));
}

QString nodeList(const percollect::Graph& graph, std::span<const std::size_t> nodes) {
  QString list;
  for (const std::size_t node : nodes) list += html::paragraph(nodeLink(graph.node(node)));
  return list;
}

QString referenceText(const percollect::Reference& reference, const QPalette& palette) {
  QString name = QString::fromStdString(reference.title.empty() ? reference.url : reference.title);
  if (name.isEmpty()) name = QString::fromStdString(reference.raw);
  QString line = reference.url.starts_with("http") ? html::link(QString::fromStdString(reference.url), name)
                                                   : name.toHtmlEscaped();
  if (!reference.author.empty()) line = html::text(reference.author) + ": " + line;
  if (!reference.note.empty()) line += "<br/>" + html::muted(html::text(reference.note), palette);
  return html::paragraph(line);
}

/// Requirements that follow from rows with this node, and what they bind.
QString boundTexts(const ProjectDocument& document, const std::vector<std::size_t>& rows) {
  std::set<std::string> ids;
  for (const std::size_t row : rows) {
    for (const std::string& id : document.requirementsOf(document.table().rows[row].key)) ids.insert(id);
  }
  QString list;
  for (const std::string& id : ids) {
    const auto item = document.item(id);
    const auto* requirement = item ? std::get_if<specs::Requirement>(&*item) : nullptr;
    if (!requirement) continue;
    QString line = html::link("item:" + QString::fromStdString(id), QString::fromStdString(id)) + " " +
                   html::text(requirement->title);
    for (const std::string& effect : requirement->effects) line += " · <i>" + html::text(effect) + "</i>";
    list += html::paragraph(line);
  }
  return list;
}

}  // namespace

QString nodeDetails(const ProjectDocument& document, std::size_t index, const QPalette& palette) {
  const percollect::Graph& graph = document.graph();
  const percollect::Node& node = graph.node(index);
  const QString id = QString::fromStdString(node.id);
  QString page = html::heading(QString::fromStdString(node.title));
  page += html::paragraph(
      html::muted(wordFor(node.kind) + " · " + html::text(node.block) + " · id " + id.toHtmlEscaped(), palette));
  if (!node.description.empty()) page += html::paragraph(html::text(node.description));

  const auto rows = document.rowsWithNode(node.id);
  page += html::section(QObject::tr("Chains"), palette);
  page += html::paragraph(QObject::tr("%1 from a phenomenon to a last cause run through this node.")
                              .arg(countText(percollect::countChains(graph, {.through = index}))));
  page +=
      rows.empty()
          ? html::paragraph(QObject::tr("No CEPRA row has it."))
          : html::paragraph(html::link("rows:" + id, rows.size() == 1 ? QObject::tr("1 CEPRA row")
                                                                      : QObject::tr("%1 CEPRA rows").arg(rows.size())));
  if (const QString bound = boundTexts(document, rows); !bound.isEmpty()) {
    page += html::section(QObject::tr("Requirements and the effects they bind"), palette) + bound;
  }
  if (!graph.parents(index).empty()) {
    page += html::section(QObject::tr("Leads to"), palette) + nodeList(graph, graph.parents(index));
  }
  if (!graph.children(index).empty()) {
    page += html::section(QObject::tr("Caused by"), palette) + nodeList(graph, graph.children(index));
  }
  if (!node.tags.empty()) {
    QStringList tags;
    for (const std::string& tag : node.tags) tags << QString::fromStdString(tag).toHtmlEscaped();
    page += html::section(QObject::tr("Tags"), palette) + html::paragraph(tags.join(", "));
  }
  for (const auto& [name, value] : node.labels) {
    page += html::section(QString::fromStdString(name), palette) + html::paragraph(html::text(value));
  }
  if (!node.references.empty()) {
    page += html::section(QObject::tr("References"), palette);
    for (const percollect::Reference& reference : node.references) page += referenceText(reference, palette);
  }
  return page;
}

QString graphDetails(const ProjectDocument& document, const QPalette& palette) {
  const percollect::Graph& graph = document.graph();
  if (graph.size() == 0) return {};
  const percollect::GraphCounts counts = percollect::countGraph(graph);
  QString page = html::heading(QString::fromStdString(graph.tree()));
  page += html::paragraph(QObject::tr("%1 nodes, %2 edges, %3 chains; the longest has %4 steps.")
                              .arg(counts.nodes)
                              .arg(counts.edges)
                              .arg(countText(counts.chains))
                              .arg(counts.longest_path));
  page += html::paragraph(QObject::tr("%1 effects, %2 design parameters, %3 system-independent causes.")
                              .arg(counts.effects)
                              .arg(counts.design_parameters)
                              .arg(counts.system_independent));
  page += html::section(QObject::tr("Phenomena"), palette);
  for (const std::size_t phenomenon : graph.phenomena()) {
    page += html::paragraph(
        nodeLink(graph.node(phenomenon)) + " " +
        html::muted(QObject::tr("%1 chains").arg(countText(percollect::countChains(graph, {.phenomenon = phenomenon}))),
                    palette));
  }
  if (const auto& import = document.specification().graph) {
    page += html::section(QObject::tr("Imported"), palette);
    page +=
        html::paragraph(html::text(import->when + " " + import->who) + "<br/>" +
                        html::muted(html::text(std::filesystem::path(import->source).filename().string()), palette));
  }
  page += html::section(QObject::tr("How to read it"), palette);
  page +=
      html::paragraph(QObject::tr("Arrows lead from a cause to what it causes. Click a node to see all chains through "
                                  "it; the button at its right end folds and unfolds its causes."));
  return page;
}

}  // namespace desktop
