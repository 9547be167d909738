// The diagnosis page, on the demo project: a real report, real proposals, decisions that reach the file when saved.
#include <QApplication>
#include <QMessageBox>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTest>
#include <QTimer>
#include <gtest/gtest.h>

#include "app/desktop/cepra_page.h"
#include "app/desktop/colours.h"
#include "app/desktop/diagnosis/diagnosis_page.h"
#include "app/desktop/file_list.h"
#include "app/desktop/main_window.h"
#include "app/desktop/screenshots.h"
#include "core/json_object.h"
#include "model/simulate.h"
#include "tests/proposals/demo_project.h"

namespace {

using desktop::DiagnosisRunner;
using desktop::MainWindow;

class DesktopDiagnosis : public testing::Test {
 protected:
  void SetUp() override {
    settings_ = std::make_unique<QSettings>(QString::fromStdString((demo_.folder() / "settings.ini").string()),
                                            QSettings::IniFormat);
    window_ = std::make_unique<MainWindow>(*settings_);
    window_->show();
    ASSERT_TRUE(window_->openProject(demo_.file()));
    window_->showTab(MainWindow::Diagnosis);
  }
  [[nodiscard]] desktop::DiagnosisPage& page() { return window_->diagnosisPage(); }
  [[nodiscard]] desktop::ProposalsPanel& panel() { return page().proposals(); }
  [[nodiscard]] specs::ProjectStore saved() const { return demo_.open(); }
  void openAndPropose() {
    ASSERT_TRUE(page().openReport(demo_.report()));
    QSignalSpy proposed(&page().runner(), &DiagnosisRunner::proposed);
    page().propose();
    ASSERT_TRUE(proposed.wait(120'000));
    ASSERT_EQ(panel().table().rowCount(), 4);
  }
  /// The demo's report with other keys.
  [[nodiscard]] std::filesystem::path reportWith(const nlohmann::json& keys) const {
    nlohmann::json json = core::readJson(demo_.report());
    json.update(keys);
    core::writeJson(demo_.folder() / "other.json", json);
    return demo_.folder() / "other.json";
  }
  [[nodiscard]] QString shownText() { return page().text().toPlainText().simplified(); }
  /// The chosen model becomes one that holds what the demo's model reported.
  void chooseRecordedModel() {
    core::SilentProgress progress;
    model::simulatePackage(model::readExperiment(demo_.folder() / "foggy-sweep"),
                           model::readModel(demo_.folder() / "model.json"), demo_.folder() / "recording", 99, progress);
    const auto file = demo_.folder().write(
        "theirs.json", R"({"format": "fidelis-model", "version": 1, "id": "theirs", "recorded": "recording"})");
    page().models().insertItem(0, "theirs.json", QString::fromStdString(file.string()));
    page().models().setCurrentIndex(0);
  }
  [[nodiscard]] const specs::Proposal& proposal(int row) {
    return window_->document().specification().proposals.at(std::size_t(row));
  }
  [[nodiscard]] cepra::Score occurrence(int row) {
    return window_->document().table().find(proposal(row).row)->occurrence;
  }

  test_proposals::DemoProject demo_;
  std::unique_ptr<QSettings> settings_;
  std::unique_ptr<MainWindow> window_;
};

TEST_F(DesktopDiagnosis, AnExperimentIsListedOnceByTheNameOfItsFolderBeforeTheQuestionForAnother) {
  QComboBox list;
  desktop::addFileQuestion(&list, "Choose…");
  EXPECT_TRUE(desktop::asksForFile(&list));
  EXPECT_TRUE(desktop::chosenFile(&list).empty());
  EXPECT_EQ(desktop::offerFile(&list, "/data/fog/experiment.json"), 0);
  EXPECT_EQ(desktop::offerFile(&list, "/data/other/../fog/experiment.json"), 0);
  EXPECT_EQ(desktop::offerFile(&list, "/data/near.json"), 1);
  EXPECT_EQ(list.itemText(0), "fog");
  EXPECT_EQ(list.itemText(1), "near.json");
  EXPECT_EQ(list.count(), 3);
  list.setCurrentIndex(0);
  EXPECT_EQ(desktop::chosenFile(&list), "/data/fog/experiment.json");
}

TEST_F(DesktopDiagnosis, WithoutAReportItSaysWhatToDo) {
  EXPECT_TRUE(page().text().toPlainText().contains("press Diagnose"));
  EXPECT_EQ(panel().table().rowCount(), 0);
}

TEST_F(DesktopDiagnosis, AReportShowsVerdictPlacesCausesAndWhatIsLeft) {
  ASSERT_TRUE(page().openReport(demo_.report()));
  const QString shown = page().text().toPlainText().simplified();
  const gap::Diagnosis& diagnosis = test_proposals::DemoProject::diagnosis();
  EXPECT_TRUE(shown.contains(QString::fromStdString(diagnosis.verdict.text)));
  for (const gap::Cause& cause : diagnosis.causes) EXPECT_TRUE(shown.contains(QString::fromStdString(cause.name)));
  for (const char* part : {"visibility_m = ", "at ranges from ", "missing echoes", "Synthetic data"}) {
    EXPECT_TRUE(shown.contains(part)) << part;
  }
}

TEST_F(DesktopDiagnosis, ACauseSaysItsFormItsSensorsAndHowSureItIs) {
  nlohmann::json causes = core::readJson(demo_.report()).at("causes");
  causes[0].update({{"variant", "droplets"}, {"sensors", {"front", "rear"}}, {"confidence", 0.625}});
  ASSERT_TRUE(page().openReport(reportWith({{"causes", causes}})));
  EXPECT_TRUE(shownText().contains("effect · droplets · sensor front, rear only")) << shownText().toStdString();
  EXPECT_TRUE(shownText().contains("62.5 %")) << shownText().toStdString();
}

TEST_F(DesktopDiagnosis, WhereHalfOfTheBeamsJudgedNoSampleIsSaidToBeUnseen) {
  ASSERT_TRUE(page().openReport(demo_.report()));
  EXPECT_TRUE(shownText().contains("on samples that no fit has seen"));
  nlohmann::json shrink = core::readJson(demo_.report()).at("shrink");
  shrink["half_of_the_beams_fitted"] = true;
  ASSERT_TRUE(page().openReport(reportWith({{"shrink", shrink}})));
  EXPECT_FALSE(shownText().contains("no fit has seen"));
  EXPECT_TRUE(shownText().contains("of which the fit saw one half of the beams")) << shownText().toStdString();
}

nlohmann::json rest(double left) {
  const nlohmann::json term = {{"covariate", "range_m"}, {"function", "1/x"}, {"coefficient", 2.0}};
  const nlohmann::json law = {{"measurand", "epw"}, {"component", "bias"}, {"unit", "m"},
                              {"constant", 0.1},    {"terms", {term}},     {"explained", 0.75}};
  return {{"left", left}, {"systematic", 0.625}, {"laws", {law}}};
}

TEST_F(DesktopDiagnosis, WhatIsLeftSaysWhetherSomethingIsStillMissingAndWhatItFollows) {
  ASSERT_TRUE(page().openReport(reportWith({{"rest", rest(0.4)}})));
  EXPECT_TRUE(shownText().contains("40 % of the differences are left")) << shownText().toStdString();
  EXPECT_TRUE(shownText().contains("something systematic is still missing"));
  EXPECT_TRUE(shownText().contains("mean of the echo pulse width 0.1 + 2/range_m m 75 %")) << shownText().toStdString();
  ASSERT_TRUE(page().openReport(reportWith({{"rest", rest(0.03)}})));
  EXPECT_TRUE(shownText().contains("So little is left"));
  EXPECT_FALSE(shownText().contains("2/range_m"));
}

nlohmann::json approximation(double ratio) {
  return {{"text", "Proxy and model under test differ."}, {"proxy", "near"}, {"ratio", ratio}};
}

TEST_F(DesktopDiagnosis, AProxyThatIsFarFromTheModelIsWarnedOfBeforeAnythingThatRestsOnIt) {
  ASSERT_TRUE(page().openReport(reportWith({{"approximation", approximation(1.4)}})));
  const auto warning = shownText().indexOf("Do not rely upon the causes");
  EXPECT_GT(warning, 0);
  EXPECT_LT(warning, shownText().indexOf("Proxy and model under test differ."));
  EXPECT_LT(warning, shownText().indexOf("Where do they differ?"));
}

TEST_F(DesktopDiagnosis, AProxyThatIsNearIsToBeBorneInMindLikeTheNotesOfTheData) {
  ASSERT_TRUE(page().openReport(
      reportWith({{"approximation", approximation(0.05)}, {"notes", {"epw was left out.", "r20 is <empty>."}}})));
  EXPECT_FALSE(shownText().contains("Do not rely"));
  EXPECT_TRUE(
      shownText().contains("To bear in mind Proxy and model under test differ. epw was left out. r20 is <empty>."))
      << shownText().toStdString();
}

TEST_F(DesktopDiagnosis, AReportWithoutNotesHasNothingToBearInMind) {
  ASSERT_TRUE(page().openReport(reportWith({{"notes", nlohmann::json::array()}})));
  EXPECT_FALSE(shownText().contains("To bear in mind"));
}

TEST_F(DesktopDiagnosis, AProxyIsAskedForWhereTheModelIsNotTheBuiltInLidar) {
  page().models().setCurrentIndex(page().models().findText("model.json"));
  EXPECT_FALSE(page().proxies().isVisible());
  chooseRecordedModel();
  EXPECT_TRUE(page().proxies().isVisible());
  EXPECT_EQ(page().proxies().currentText(), "Default");

  page().experiments().setCurrentIndex(page().experiments().findText("foggy-sweep"));
  page().proxies().setCurrentIndex(page().proxies().findText("model.json"));
  QSignalSpy diagnosed(&page().runner(), &DiagnosisRunner::diagnosed);
  page().diagnose();
  ASSERT_TRUE(diagnosed.wait(120'000));
  EXPECT_TRUE(shownText().contains("computed in a built-in proxy (demo-lidar;")) << shownText().toStdString();
}

TEST_F(DesktopDiagnosis, AProxyOfTheBuiltInLidarIsRefusedInWords) {
  QString told;
  QTimer closer;
  QObject::connect(&closer, &QTimer::timeout, [&told] {
    auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    if (!box) return;
    told = box->text() + box->informativeText();
    box->accept();
  });
  closer.start(50);
  QSignalSpy failed(&page().runner(), &DiagnosisRunner::failed);
  page().runner().diagnose({.experiment = demo_.folder() / "foggy-sweep",
                            .model = demo_.folder() / "model.json",
                            .proxy = demo_.folder() / "model.json",
                            .project = demo_.file(),
                            .report = demo_.folder() / "reports" / "none.json"});
  ASSERT_TRUE(failed.wait(120'000) || failed.count() == 1);
  EXPECT_TRUE(told.contains("No proxy is needed")) << told.toStdString();
  EXPECT_FALSE(std::filesystem::exists(demo_.folder() / "reports"));
}

TEST_F(DesktopDiagnosis, TheChosenExperimentIsDiagnosedInTheBackground) {
  page().experiments().setCurrentIndex(page().experiments().findText("foggy-sweep"));
  QSignalSpy diagnosed(&page().runner(), &DiagnosisRunner::diagnosed);
  page().diagnose();
  ASSERT_TRUE(page().runner().isRunning());
  ASSERT_TRUE(diagnosed.wait(120'000));
  const QString shown = page().text().toPlainText();
  EXPECT_TRUE(shown.contains("atmospheric-attenuation"));
  EXPECT_TRUE(shown.contains("EchoPulseWidthError_Fog_2")) << "the flips";
  EXPECT_FALSE(std::filesystem::is_empty(demo_.folder() / "reports"));
}

TEST_F(DesktopDiagnosis, ACancelledDiagnosisLeavesNothing) {
  page().experiments().setCurrentIndex(page().experiments().findText("foggy-sweep"));
  QSignalSpy cancelled(&page().runner(), &DiagnosisRunner::cancelled);
  page().diagnose();
  page().cancel();
  ASSERT_TRUE(cancelled.wait(120'000));
  EXPECT_FALSE(std::filesystem::exists(demo_.folder() / "reports"));
}

TEST_F(DesktopDiagnosis, ProposalsAreStoredOnceAtOnce) {
  openAndPropose();
  EXPECT_EQ(saved().proposals().size(), 4u);
  openAndPropose();
  EXPECT_EQ(saved().proposals().size(), 4u);
}

TEST_F(DesktopDiagnosis, AcceptingIsOneUndoStepAndReachesTheFileWhenSaved) {
  openAndPropose();
  const cepra::Score before = occurrence(0);
  panel().table().setCurrentCell(0, 0);
  panel().acceptCurrent();
  EXPECT_EQ(occurrence(0).value, proposal(0).occurrence);
  EXPECT_EQ(proposal(0).state, specs::ProposalState::Accepted);
  EXPECT_TRUE(saved().proposals()[0].isOpen());

  window_->document().undoStack().undo();
  EXPECT_EQ(occurrence(0), before);
  EXPECT_TRUE(proposal(0).isOpen());
  EXPECT_FALSE(window_->isWindowModified());

  window_->document().undoStack().redo();
  ASSERT_TRUE(window_->save());
  EXPECT_EQ(saved().proposals()[0].state, specs::ProposalState::Accepted);
  EXPECT_EQ(saved().cepra().find(proposal(0).row)->occurrence, occurrence(0));
  EXPECT_EQ(saved().history(proposal(0).row).back().what, "proposal P1 accepted");

  // Undone after saving, and saved again: the file follows.
  window_->document().undoStack().undo();
  ASSERT_TRUE(window_->save());
  EXPECT_TRUE(saved().proposals()[0].isOpen());
  EXPECT_EQ(saved().cepra().find(proposal(0).row)->occurrence, before);
}

TEST_F(DesktopDiagnosis, AnAcceptedTestIsAddedWithItsLinks) {
  openAndPropose();
  const std::size_t before = saved().all<specs::AcceptanceTest>().size();
  panel().table().setCurrentCell(3, 0);
  panel().acceptCurrent();
  ASSERT_TRUE(window_->save());
  EXPECT_EQ(saved().all<specs::AcceptanceTest>().size(), before + 1);
}

TEST_F(DesktopDiagnosis, DismissingWantsAReason) {
  openAndPropose();
  panel().table().setCurrentCell(1, 0);
  QTimer::singleShot(200, [] {
    if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) box->accept();
  });
  panel().dismissCurrent(" ");
  EXPECT_TRUE(proposal(1).isOpen());
  panel().dismissCurrent("denser than any fog here");
  ASSERT_TRUE(window_->save());
  EXPECT_EQ(saved().proposals()[1].reason, "denser than any fog here");
  EXPECT_TRUE(panel().details().toPlainText().contains("denser than any fog here"));
}

TEST_F(DesktopDiagnosis, ARowThatWasScoredMeanwhileIsAskedAbout) {
  openAndPropose();
  auto& model = window_->cepraPage().model();
  const auto& rows = window_->document().table().rows;
  const auto row = int(window_->document().table().find(proposal(0).row) - rows.data());
  ASSERT_TRUE(model.setData(model.index(row, desktop::CepraModel::Occurrence), "2"));
  panel().table().setCurrentCell(0, 0);
  EXPECT_TRUE(panel().details().toPlainText().contains("Changed since"));
  QString asked;
  QTimer::singleShot(200, [&asked] {
    if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
      asked = box->text();
      box->button(QMessageBox::Cancel)->click();
    }
  });
  panel().acceptCurrent();
  EXPECT_TRUE(asked.contains("is 2")) << asked.toStdString();
  EXPECT_EQ(occurrence(0).value, 2);
  EXPECT_TRUE(proposal(0).isOpen());
}

TEST_F(DesktopDiagnosis, AProposalLeadsToItsRow) {
  openAndPropose();
  panel().table().setCurrentCell(0, 0);
  panel().table().setFocus();
  QTest::keyClick(&panel().table(), Qt::Key_Return);
  EXPECT_EQ(window_->findChild<QTabWidget*>("tabs")->currentIndex(), MainWindow::Relevance);
}

TEST_F(DesktopDiagnosis, AFileThatIsNoReportIsRefusedAndTheOldReportStays) {
  ASSERT_TRUE(page().openReport(demo_.report()));
  QTimer::singleShot(200, [] {
    if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) box->accept();
  });
  EXPECT_FALSE(page().openReport(demo_.folder() / "model.json"));
  EXPECT_TRUE(page().text().toPlainText().contains("atmospheric-attenuation"));
}

TEST_F(DesktopDiagnosis, ThePictureOfThePage) {
  openAndPropose();
  panel().table().setCurrentCell(0, 0);
  desktop::settle(*window_);
  const std::filesystem::path folder = std::filesystem::path(FIDELIS_SCREENSHOTS) / "diagnosis";
  std::filesystem::create_directories(folder);
  const auto shoot = [&](const char* name) {
    desktop::settle(*window_);
    EXPECT_TRUE(window_->grab().save(QString::fromStdString((folder / name).string())));
  };
  shoot("light.png");
  QApplication::setPalette(desktop::darkPalette());
  shoot("dark.png");
  QApplication::setPalette(desktop::lightPalette());
  window_->resize(1100, 720);
  panel().table().setCurrentCell(3, 0);
  shoot("small.png");
  ASSERT_TRUE(page().openReport(reportWith({{"rest", rest(0.4)}})));
  page().text().verticalScrollBar()->setValue(page().text().verticalScrollBar()->maximum());
  shoot("rest.png");
  nlohmann::json far = approximation(1.4);
  far["text"] =
      "The model under test is not the built-in lidar. What an effect would change was computed in a built-in proxy: "
      "an "
      "approximation. Proxy and model under test differ by a total gap of 14.2, the measurement and the model under "
      "test "
      "by 11.3. The proxy is no nearer to the model under test than the measurement is: do not rely upon the causes, "
      "and "
      "give a better proxy.";
  chooseRecordedModel();
  ASSERT_TRUE(page().openReport(
      reportWith({{"approximation", far}, {"notes", {"Intensity was left out: sample r20 lacks its column."}}})));
  shoot("proxy.png");
}

}  // namespace
