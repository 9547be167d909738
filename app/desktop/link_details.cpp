#include "app/desktop/link_details.h"

#include "app/desktop/colours.h"
#include "app/desktop/html.h"

namespace desktop {

namespace {

QString line(const ProjectDocument& document, const specs::Link& link, const std::string& other,
             const QPalette& palette) {
  const specs::Entry* entry = document.links().find(other);
  if (!entry) return {};
  const QString id = QString::fromStdString(other);
  const bool is_row = entry->kind == specs::Kind::CepraRow;
  QString text = html::link((is_row ? "row:" : "item:") + id, QString::fromStdString(entry->title));
  QString about = html::text(std::string(specs::name(entry->kind)));
  if (!is_row) about += " · " + id.toHtmlEscaped();
  if (entry->status) about += " · " + wordFor(*entry->status);
  const QString ends = QString::fromStdString(link.from + "|" + link.to);
  text += "<br/>" + html::muted(about, palette) + " · " + html::link("unlink:" + ends, QObject::tr("unlink"));
  if (link.suspect) {
    text += "<br/><b>" + QObject::tr("Suspect: an end has changed.") + "</b> " +
            html::link("reviewed:" + ends, QObject::tr("I have looked at it"));
  }
  return html::paragraph(text);
}

}  // namespace

QString linkDetails(const ProjectDocument& document, const std::string& id, const QPalette& palette) {
  if (!document.links().find(id)) return {};
  QString page;
  const auto& verdicts = document.specification().verdicts;
  if (const auto verdict = verdicts.find(id); verdict != verdicts.end()) {
    page += html::section(QObject::tr("Last verdict"), palette);
    page += html::paragraph(html::link("result:" + QString::fromStdString(id), wordFor(verdict->second.verdict)) + " " +
                            html::text(verdict->second.text));
  }
  page += html::section(QObject::tr("Follows from"), palette);
  const auto& origins = document.links().originsOf(id);
  for (const specs::Link& link : origins) page += line(document, link, link.from, palette);
  if (origins.empty()) page += html::paragraph(html::muted(QObject::tr("nothing"), palette));
  page += html::section(QObject::tr("Leads to"), palette);
  const auto& followers = document.links().followersOf(id);
  for (const specs::Link& link : followers) page += line(document, link, link.to, palette);
  if (followers.empty()) page += html::paragraph(html::muted(QObject::tr("nothing"), palette));
  const auto history = document.history(id);
  if (!history.empty()) page += html::section(QObject::tr("History (saved changes)"), palette);
  for (const specs::Change& change : history) {
    page += html::paragraph(html::muted(html::text(change.when + " " + change.who), palette) + "<br/>" +
                            html::text(change.what));
  }
  return page;
}

}  // namespace desktop
