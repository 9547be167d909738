#include "app/desktop/row_details.h"

#include "app/desktop/colours.h"
#include "app/desktop/html.h"

namespace desktop {

namespace {

QString scoreText(const cepra::Score& score, const QPalette& palette) {
  QString text = score.value ? QStringLiteral("<b>%1</b>").arg(*score.value) : QObject::tr("not scored");
  if (!score.expert.empty()) text += " " + html::muted(html::text(score.expert), palette);
  if (!score.rationale.empty()) text += "<br/>" + html::text(score.rationale);
  return html::paragraph(text);
}

QString causeList(const std::vector<cepra::Cause>& causes, const QString& title, const QPalette& palette) {
  if (causes.empty()) return {};
  QString list = html::section(title, palette);
  for (const cepra::Cause& cause : causes) {
    list +=
        html::paragraph(html::link("node:" + QString::fromStdString(cause.id), QString::fromStdString(cause.title)));
  }
  return list;
}

}  // namespace

QString rowDetails(const ProjectDocument& document, const cepra::Row& row, const QPalette& palette) {
  QString page;
  if (row.isSuspect()) {
    page += html::paragraph("<b>" + QObject::tr("Suspect") + "</b>: " + html::text(row.suspect));
  }
  page += html::section(QObject::tr("Path, from the phenomenon to its cause"), palette);
  QString indent;
  for (const cepra::Effect& effect : row.effects) {
    page += html::paragraph(
        indent + html::link("node:" + QString::fromStdString(effect.id), QString::fromStdString(effect.title)));
    indent = indent.isEmpty() ? QString::fromUtf8("↳ ") : "&nbsp;&nbsp;" + indent;
  }
  page += causeList(row.causesOfKind(percollect::NodeKind::DesignParameter), QObject::tr("Design parameters"), palette);
  page += causeList(row.causesOfKind(percollect::NodeKind::SystemIndependent), QObject::tr("System-independent causes"),
                    palette);
  page += html::section(QObject::tr("Occurrence"), palette) + scoreText(row.occurrence, palette);
  page += html::section(QObject::tr("Impact"), palette) + scoreText(row.impact, palette);
  if (const auto relevance = row.relevance()) {
    page += html::section(QObject::tr("Relevance"), palette) +
            html::paragraph(QObject::tr("<b>%1</b> of 20").arg(*relevance));
  }
  if (!row.notes.empty()) page += html::section(QObject::tr("Notes"), palette) + html::paragraph(html::text(row.notes));
  page += html::section(QObject::tr("Requirements"), palette);
  for (const std::string& id : document.requirementsOf(row.key)) {
    const specs::Entry* entry = document.links().find(id);
    page += html::paragraph(html::link("item:" + QString::fromStdString(id), QString::fromStdString(id)) + " " +
                            (entry ? html::text(entry->title) : QString()));
  }
  page += html::paragraph(html::link("add:" + QString::fromStdString(row.key), QObject::tr("Add a requirement")));
  return page;
}

}  // namespace desktop
