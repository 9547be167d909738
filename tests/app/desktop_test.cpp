// Drives the real window on a real project file in a temporary folder. Runs under any platform plug-in: Xvfb (CTest
// does that) or QT_QPA_PLATFORM=offscreen. Pictures of every tab stay in build/screenshots.
#include <QAbstractItemModelTester>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QElapsedTimer>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTest>
#include <QTimer>
#include <fstream>
#include <gtest/gtest.h>
#include <iostream>
#include <set>

#include "app/desktop/cepra_page.h"
#include "app/desktop/cloud/cloud_page.h"
#include "app/desktop/colours.h"
#include "app/desktop/graph_page.h"
#include "app/desktop/main_window.h"
#include "app/desktop/recent_files.h"
#include "app/desktop/results_page.h"
#include "app/desktop/screenshots.h"
#include "app/desktop/spec_page.h"
#include "cepra/csv.h"
#include "core/json_object.h"
#include "model/simulate.h"
#include "percollect/read_graph.h"
#include "specs/import_graph.h"
#include "specs/lists.h"
#include "tests/support/paths.h"
#include "tests/support/program.h"

namespace {

using desktop::CepraModel;
using desktop::Emphasis;
using desktop::MainWindow;

const specs::Signature kEve{.who = "eve", .when = "2026-01-02T03:04:05Z"};

/// The demo project in a folder of its own, with an open window on it.
class Desktop : public testing::Test {
 protected:
  void SetUp() override {
    const auto demo = test_support::sourceFolder() / "resources" / "demo";
    for (const char* part : {"range-sweep", "foggy-sweep", "model.json"}) {
      std::filesystem::copy(demo / part, folder_ / part, std::filesystem::copy_options::recursive);
    }
    {
      auto store = specs::ProjectStore::create(file());
      specs::importGraph(store, percollect::readGraph(demo / "lidar-excerpt.json").graph, kEve);
      specs::applyLists(store, specs::readLists(demo / "specification", store.specification()), false, kEve);
      store.saveCepra(cepra::importCsv(store.cepra(), demo / "cepra.csv").table, kEve);
    }
    settings_ =
        std::make_unique<QSettings>(QString::fromStdString((folder_ / "settings.ini").string()), QSettings::IniFormat);
    openWindow();
  }

  void openWindow() {
    window_ = std::make_unique<MainWindow>(*settings_);
    window_->show();
    ASSERT_TRUE(window_->openProject(file()));
    desktop::settle(*window_);
  }

  [[nodiscard]] std::filesystem::path file() const { return folder_ / "demo.fidelis"; }
  [[nodiscard]] specs::ProjectStore saved() const { return specs::ProjectStore::open(file()); }
  [[nodiscard]] const percollect::Graph& graph() const { return window_->document().graph(); }
  template <class T>
  T* child(const char* name) {
    return window_->findChild<T*>(name);
  }
  [[nodiscard]] QModelIndex cell(int row, int column) {
    return window_->cepraPage().view().model()->index(row, column);
  }
  void pressKey(int key, Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(&window_->cepraPage().view(), Qt::Key(key), modifiers);
  }

  test_support::TemporaryFolder folder_;
  std::unique_ptr<QSettings> settings_;
  std::unique_ptr<MainWindow> window_;
};

TEST_F(Desktop, SearchInTheGraphCountsItsHitsAndDimsTheRest) {
  QTest::keyClicks(child<QLineEdit>("graphSearch"), "noise");
  std::size_t expected = 0;
  for (const percollect::Node& node : graph().nodes()) {
    const auto holds = [](const std::string& text) {
      return QString::fromStdString(text).contains("noise", Qt::CaseInsensitive);
    };
    expected += holds(node.title) || std::ranges::any_of(node.tags, holds);
  }
  ASSERT_GT(expected, 0u);
  EXPECT_TRUE(child<QLabel>("graphHits")->text().startsWith(QString::number(expected)));
  EXPECT_EQ(window_->graphPage().scene().emphasisOf(graph().phenomena()[0]), Emphasis::Dimmed);
}

TEST_F(Desktop, AClickOnANodeHighlightsItsChains) {
  auto& scene = window_->graphPage().scene();
  auto& view = window_->graphPage().view();
  const std::size_t phenomenon = graph().phenomena()[0];
  const std::size_t cause = graph().children(phenomenon)[0];
  desktop::NodeItem* item = scene.itemOf(cause);
  ASSERT_NE(item, nullptr);
  view.fit();
  QTest::mouseClick(view.viewport(), Qt::LeftButton, {}, view.mapFromScene(item->scenePos() - QPointF(60, 0)));
  EXPECT_EQ(scene.selected(), cause);
  EXPECT_EQ(scene.emphasisOf(cause), Emphasis::Selected);
  EXPECT_EQ(scene.emphasisOf(phenomenon), Emphasis::Chain);
}

TEST_F(Desktop, ANodeLeadsToItsRowsInTheTable) {
  const std::string id = graph().node(graph().phenomena()[0]).id;
  emit window_->graphPage().rowsRequested(QString::fromStdString(id));
  EXPECT_EQ(child<QTabWidget>("tabs")->currentIndex(), MainWindow::Relevance);
  EXPECT_EQ(std::size_t(window_->cepraPage().view().model()->rowCount()), window_->document().rowsWithNode(id).size());
}

TEST_F(Desktop, ADigitScoresUndoTakesItBackAndSaveKeepsIt) {
  window_->showTab(MainWindow::Relevance);
  auto& view = window_->cepraPage().view();
  view.setCurrentIndex(cell(0, CepraModel::Occurrence));
  const auto before = window_->document().table().rows[0].occurrence.value;
  pressKey(Qt::Key_0);
  EXPECT_EQ(window_->document().table().rows[0].occurrence.value, 10);
  EXPECT_TRUE(window_->isWindowModified());
  EXPECT_EQ(window_->document().undoStack().undoText(), "score 10");

  window_->document().undoStack().undo();
  EXPECT_EQ(window_->document().table().rows[0].occurrence.value, before);
  EXPECT_FALSE(window_->isWindowModified());

  pressKey(Qt::Key_3);
  EXPECT_EQ(saved().cepra().rows[0].occurrence.value, before);  // not before it is saved
  ASSERT_TRUE(window_->save());
  EXPECT_FALSE(window_->isWindowModified());
  EXPECT_EQ(saved().cepra().rows[0].occurrence.value, 3);

  window_.reset();
  openWindow();
  EXPECT_EQ(window_->document().table().rows[0].occurrence.value, 3);
}

TEST_F(Desktop, ATypedScoreThatIsNoneIsRefusedInWords) {
  auto& model = window_->cepraPage().model();
  const auto before = window_->document().table().rows[1].impact.value;
  EXPECT_FALSE(model.setData(model.index(1, CepraModel::Impact), "11"));
  EXPECT_EQ(window_->document().table().rows[1].impact.value, before);
  EXPECT_TRUE(child<QLabel>("cepraMessage")->text().contains("'11' is no score: whole numbers from 1 to 10"));
  EXPECT_FALSE(window_->isWindowModified());
}

TEST_F(Desktop, BlocksArePastedAsOneStepAndBadCellsAreNamed) {
  auto& view = window_->cepraPage().view();
  view.setCurrentIndex(cell(0, CepraModel::Occurrence));
  QApplication::clipboard()->setText("2\t9\n4\tmany\n");
  pressKey(Qt::Key_V, Qt::ControlModifier);
  const auto& rows = window_->document().table().rows;
  EXPECT_EQ(rows[0].occurrence.value, 2);
  EXPECT_EQ(rows[0].impact.value, 9);
  EXPECT_EQ(rows[1].occurrence.value, 4);
  EXPECT_TRUE(child<QLabel>("cepraMessage")->text().contains("Row 2, I: 'many' is no score"));
  EXPECT_EQ(window_->document().undoStack().count(), 1);
}

TEST_F(Desktop, ARationaleIsTypedAsInASpreadsheet) {
  window_->showTab(MainWindow::Relevance);
  auto& view = window_->cepraPage().view();
  view.setCurrentIndex(cell(0, CepraModel::OccurrenceWhy));
  pressKey(Qt::Key_F2);
  auto* editor = view.findChild<QPlainTextEdit*>();
  ASSERT_NE(editor, nullptr);
  QTest::keyClicks(editor, "seen in winter");
  QTest::keyClick(editor, Qt::Key_Return);
  EXPECT_EQ(window_->document().table().rows[0].occurrence.rationale, "seen in winter");
  EXPECT_EQ(view.currentIndex(), cell(1, CepraModel::OccurrenceWhy));
}

TEST_F(Desktop, FilteringCountsItsHits) {
  QTest::keyClicks(child<QLineEdit>("cepraSearch"), "fog");
  const int shown = window_->cepraPage().view().model()->rowCount();
  EXPECT_LT(shown, int(window_->document().table().rows.size()));
  EXPECT_EQ(child<QLabel>("cepraCount")->text(),
            QString("%1 of %2 rows").arg(shown).arg(window_->document().table().rows.size()));
}

TEST_F(Desktop, TypingInAFieldIsOneStepAndReachesTheFile) {
  window_->showTab(MainWindow::Specification);
  const std::string id = window_->document().specification().requirements[0].id;
  window_->specPage().showItem(id);
  auto* title = qobject_cast<QLineEdit*>(window_->specPage().form().editor("title"));
  title->selectAll();
  QTest::keyClicks(title, "A new title");
  EXPECT_EQ(window_->document().undoStack().count(), 1);
  EXPECT_EQ(window_->specPage().tree().currentIndex().siblingAtColumn(0).data().toString(), "A new title");
  window_->document().undoStack().undo();
  EXPECT_NE(title->text(), "A new title");
  window_->document().undoStack().redo();
  EXPECT_EQ(title->text(), "A new title");
  ASSERT_TRUE(window_->save());
  EXPECT_EQ(saved().find<specs::Requirement>(id)->title, "A new title");
}

TEST_F(Desktop, ARemovedItemComesBackWithItsLinks) {
  auto& document = window_->document();
  const std::string id = document.specification().requirements[0].id;
  const auto before = document.specification();
  document.removeItem(id);
  EXPECT_FALSE(document.item(id));
  ASSERT_TRUE(window_->save());
  document.undoStack().undo();
  ASSERT_TRUE(window_->save());
  EXPECT_EQ(saved().specification().requirements, before.requirements);
  EXPECT_EQ(saved().specification().links, before.links);
}

TEST_F(Desktop, ALinkThatMayNotBeIsRefusedWithPlaceAndRemedy) {
  auto& document = window_->document();
  const std::string test = document.specification().tests[0].id;
  const std::string requirement = document.specification().requirements[0].id;
  try {
    document.setLinked(test, requirement, true);
    FAIL() << "was taken";
  } catch (const core::InputError& error) {
    EXPECT_EQ(error.place().item, test + " -> " + requirement);
    EXPECT_EQ(error.remedy().substr(0, 23), "Links lead from a CEPRA");
  }
}

TEST_F(Desktop, AnAcceptanceTestRunsInTheBackgroundAndItsVerdictIsStored) {
  window_->showTab(MainWindow::Results);
  auto& results = window_->resultsPage();
  results.tests().selectRow(0);
  QSignalSpy finished(&results.runner(), &desktop::TestRunner::finished);
  results.runSelected();
  EXPECT_TRUE(results.runner().isRunning());
  ASSERT_TRUE(finished.wait(120'000));
  const std::string id = window_->document().specification().tests[0].id;
  EXPECT_EQ(saved().latestVerdicts().count(id), 1u);
  EXPECT_GT(results.numbers().rowCount(), 0);
  EXPECT_TRUE(results.plot().hasFigure());
}

TEST_F(Desktop, ACancelledRunStoresNothing) {
  auto& results = window_->resultsPage();
  QSignalSpy cancelled(&results.runner(), &desktop::TestRunner::cancelled);
  results.runAll();
  results.cancel();
  ASSERT_TRUE(cancelled.wait(120'000));
  EXPECT_TRUE(saved().latestRuns().empty());
}

TEST_F(Desktop, ARunNeverStoresInAProjectThatWasOpenedMeanwhile) {
  const auto other = folder_ / "other.fidelis";
  std::filesystem::copy(file(), other);
  window_->resultsPage().runAll();
  ASSERT_TRUE(window_->openProject(other));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !window_->resultsPage().runner().isRunning(); }, 120'000));
  desktop::settle(*window_);
  EXPECT_TRUE(specs::ProjectStore::open(other).latestRuns().empty());
}

TEST_F(Desktop, AFileThatIsNoProjectIsRefusedAndTheOldProjectStays) {
  const auto broken = folder_.write("broken.fidelis", "this is no database");
  QString shown;
  QTimer::singleShot(200, [&shown] {
    if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
      shown = box->text() + box->informativeText();
      box->accept();
    }
  });
  EXPECT_FALSE(window_->openProject(broken));
  EXPECT_TRUE(shown.contains("Where")) << shown.toStdString();
  EXPECT_TRUE(shown.contains("broken.fidelis"));
  EXPECT_TRUE(shown.contains("What to do"));
  EXPECT_EQ(window_->document().file(), file());
}

TEST_F(Desktop, WindowLayoutIsKeptInTheSettings) {
  window_->cepraPage().header().resizeSection(CepraModel::Notes, 234);
  window_->close();
  window_.reset();
  openWindow();
  EXPECT_EQ(window_->cepraPage().header().sectionSize(CepraModel::Notes), 234);
}

TEST_F(Desktop, ClosingWithUnsavedChangesAsksAndCancelKeepsTheWindow) {
  auto& model = window_->cepraPage().model();
  ASSERT_TRUE(model.setData(model.index(0, CepraModel::Notes), "unsaved"));
  QTimer::singleShot(200, [] {
    if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
      box->button(QMessageBox::Cancel)->click();
    }
  });
  EXPECT_FALSE(window_->close());
  EXPECT_TRUE(window_->isVisible());
  window_->document().undoStack().undo();
}

TEST_F(Desktop, EveryEntryFieldAndViewHasAnAccessibleName) {
  for (const QWidget* widget : window_->findChildren<QWidget*>()) {
    const bool speaks = qobject_cast<const QLineEdit*>(widget) || qobject_cast<const QPlainTextEdit*>(widget) ||
                        qobject_cast<const QComboBox*>(widget) || qobject_cast<const QTableView*>(widget) ||
                        qobject_cast<const QTreeView*>(widget) || qobject_cast<const QTextBrowser*>(widget);
    if (!speaks || widget->parent()->inherits("QComboBox") || widget->parent()->inherits("QComboBoxPrivateContainer"))
      continue;
    EXPECT_FALSE(widget->accessibleName().isEmpty())
        << widget->metaObject()->className() << " '" << widget->objectName().toStdString() << "'";
  }
}

TEST_F(Desktop, TheModelsKeepTheRulesOfQt) {
  const auto fatal = QAbstractItemModelTester::FailureReportingMode::Fatal;
  const QAbstractItemModelTester table(&window_->cepraPage().model(), fatal);
  const QAbstractItemModelTester tree(window_->specPage().tree().model(), fatal);
  const QAbstractItemModelTester tests(window_->resultsPage().tests().model(), fatal);
  auto& model = window_->cepraPage().model();
  EXPECT_TRUE(model.setData(model.index(0, CepraModel::Impact), "4"));
  window_->document().removeItem(window_->document().specification().tests[0].id);
  window_->document().undoStack().undo();
  window_->document().undoStack().undo();
  window_->document().reload();
}

// The program itself, without a screen.
TEST_F(Desktop, TheProgramTakesPicturesAndRefusesWhatIsNoProject) {
  const std::string settings = (folder_ / "s.ini").string();
  const auto good =
      test_support::runProgram("fidelis-desktop", {file().string(), "--settings", settings, "-platform", "offscreen",
                                                   "--screenshot", (folder_ / "shots").string()});
  EXPECT_EQ(good.status, 0) << good.messages;
  EXPECT_TRUE(std::filesystem::exists(folder_ / "shots" / "graph.png"));
  const auto bad = test_support::runProgram(
      "fidelis-desktop", {(folder_ / "no.fidelis").string(), "--settings", settings, "-platform", "offscreen",
                          "--screenshot", (folder_ / "shots").string()});
  EXPECT_EQ(bad.status, 2);
  EXPECT_NE(bad.messages.find("no.fidelis"), std::string::npos) << bad.messages;
}

TEST_F(Desktop, TheProjectIsRememberedAmongTheRecentFiles) {
  EXPECT_EQ(desktop::recentFiles(*settings_), QStringList{QString::fromStdString(file().string())});
}

/// A street before a spinning scanner, 1.8 m above the ground: cars, posts, a wall. The "measurement" is a simulation
/// in rain; the model that is to be compared knows none.
class DesktopCloud : public Desktop {
 protected:
  void SetUp() override {
    Desktop::SetUp();
    const nlohmann::json model = modelWith({{"beam-divergence", nlohmann::json::object()}});
    nlohmann::json wet = modelWith({{"beam-divergence", nlohmann::json::object()},
                                    {"atmospheric-attenuation", {{"visibility_m", 60.0}}},
                                    {"range-offset", {{"offset_m", 0.2}}}});
    core::writeJson(folder_ / "dry.json", model);
    std::filesystem::create_directories(folder_ / "truth");
    core::writeJson(folder_ / "truth/experiment.json", street());
    core::SilentProgress silent;
    model::simulatePackage(model::readExperiment(folder_ / "truth"), model::parseModel(wet, "wet.json"),
                           folder_ / "street", 11, silent);
    window_->showTab(MainWindow::Cloud);
  }
  static nlohmann::json object(const std::string& id, nlohmann::json shape, std::vector<double> position,
                               double yaw_deg = 0.0) {
    return {{"id", id},
            {"shape", std::move(shape)},
            {"pose", {{"position_m", std::move(position)}, {"yaw_pitch_roll_deg", {yaw_deg, 0, 0}}}},
            {"material", "grey"}};
  }
  static nlohmann::json modelWith(nlohmann::json effects) {
    return {{"format", "fidelis-model"}, {"version", 1}, {"id", "street-model"},         {"sensor", kSensor},
            {"rays_per_beam", {1, 1}},   {"seed", 3},    {"effects", std::move(effects)}};
  }
  static nlohmann::json street() {
    const auto car = [](std::vector<double> size) { return nlohmann::json{{"type", "box"}, {"size_m", size}}; };
    nlohmann::json scene{
        object("road", {{"type", "plane"}}, {0, 0, -1.8}),      object("car-1", car({4.4, 1.8, 1.4}), {12, 3, -1.1}, 4),
        object("car-2", car({4.4, 1.8, 1.4}), {19, 3.2, -1.1}), object("van", car({5.5, 2.0, 2.2}), {16, -4, -0.7}, -3),
        object("wall", car({60, 0.4, 5}), {25, 9, 0.7}),        object("house", car({20, 8, 9}), {24, -14, 2.7})};
    for (int k = 0; k < 5; ++k) {
      scene.push_back(object("post-" + std::to_string(k), {{"type", "cylinder"}, {"radius_m", 0.12}, {"height_m", 4.5}},
                             {8.0 + 6 * k, -6.5, 0.45}));
    }
    return {{"format", "fidelis-experiment"},
            {"version", 1},
            {"id", "street"},
            {"source", "synthetic: a test"},
            {"sensor", kSensor},
            {"measurands", {{{"name", "range"}, {"column", "range_m"}, {"unit", "m"}, {"resolution", 0.01}}}},
            {"materials", {{"grey", {{"reflectivity", 0.4}}}}},
            {"scene", scene},
            {"samples", {{{"id", "street"}, {"frames", 1}}, {{"id", "again"}, {"frames", 2}}}}};
  }
  desktop::CloudPage& page() { return window_->cloudPage(); }
  desktop::CloudView& view() { return page().view(); }
  bool read() {
    return QTest::qWaitFor([this] { return !page().isLoading(); }, 60'000);
  }
  bool open(const std::filesystem::path& file) { return page().openExperiment(file) && read(); }
  /// Of the shown detections' places, in shares of the window: how far the farthest is from the middle, 1 at the edge.
  double farthestOut() {
    double farthest = 0.0;
    const auto* cloud = page().cloud(desktop::CloudSource::Measured);
    for (std::size_t i = 0; cloud && i < cloud->size(); ++i) {
      const QPointF at = view().placeOf({desktop::CloudSource::Measured, i});
      farthest = std::max(
          {farthest, std::abs(2.0 * at.x() / view().width() - 1.0), std::abs(2.0 * at.y() / view().height() - 1.0)});
    }
    return farthest;
  }
  void simulate() {
    QSignalSpy finished(&page().runner(), &desktop::SimulationRunner::finished);
    page().simulate();
    ASSERT_TRUE(page().runner().isRunning());
    ASSERT_TRUE(finished.wait(120'000));
  }

  static constexpr const char* kSensor = "velodyne-vlp-16";
};

TEST_F(DesktopCloud, OffersTheExperimentsOfTheProjectAndOpensOthers) {
  ASSERT_TRUE(read());
  EXPECT_NE(page().cloud(desktop::CloudSource::Measured), nullptr);  // the first test's
  ASSERT_TRUE(open(folder_ / "street"));
  const model::Experiment street = model::readExperiment(folder_ / "street");
  EXPECT_EQ(page().cloud(desktop::CloudSource::Measured)->size(),
            model::readMeasurements(street, street.samples[0]).size());
  EXPECT_EQ(view().shownPoints(), page().cloud(desktop::CloudSource::Measured)->size());
}

TEST_F(DesktopCloud, AModelIsSimulatedInTheBackgroundAndLaidOverTheMeasurement) {
  ASSERT_TRUE(open(folder_ / "street"));
  page().chooseModel(folder_ / "dry.json");
  simulate();
  const auto* simulated = page().cloud(desktop::CloudSource::Simulated);
  ASSERT_NE(simulated, nullptr);
  const auto* measured = page().cloud(desktop::CloudSource::Measured);
  EXPECT_EQ(view().shownPoints(), measured->size() + simulated->size());
  view().setVisible(desktop::CloudSource::Measured, false);
  EXPECT_EQ(view().shownPoints(), simulated->size());
}

TEST_F(DesktopCloud, AClickOnAPointShowsItsValuesAndTheSameBeamOfTheOtherSide) {
  ASSERT_TRUE(open(folder_ / "street"));
  page().chooseModel(folder_ / "dry.json");
  simulate();
  view().setVisible(desktop::CloudSource::Simulated, false);
  const auto& cloud = *page().cloud(desktop::CloudSource::Measured);
  const desktop::PickedPoint wanted{desktop::CloudSource::Measured, cloud.size() / 3};
  QTest::mouseClick(&view(), Qt::LeftButton, {}, view().placeOf(wanted).toPoint());
  ASSERT_TRUE(view().picked());
  const std::size_t picked = view().picked()->index;  // it or one before it
  EXPECT_LT((view().placeOf({desktop::CloudSource::Measured, picked}) - view().placeOf(wanted)).manhattanLength(), 15);
  const QString text = child<QTextBrowser>("cloudValues")->toPlainText();
  EXPECT_TRUE(text.contains(QString::number(cloud.detections.range_m[picked], 'f', 3) + " m")) << text.toStdString();
  EXPECT_TRUE(text.contains("The same beam, simulated"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return page().waveform().beam().has_value(); }, 60'000));
  EXPECT_EQ(page().waveform().beam()->beam.layer, cloud.detections.layer[picked]);
  EXPECT_NEAR(page().waveform().beam()->beam.azimuth_rad, cloud.detections.azimuth_rad[picked], 1e-6);
  QTest::keyClick(&view(), Qt::Key_Escape);
  EXPECT_FALSE(view().picked());
  EXPECT_FALSE(page().waveform().isVisible());
}

TEST_F(DesktopCloud, OneFrameAtATime) {
  ASSERT_TRUE(open(folder_ / "street"));
  const auto frames = [this](int sample) {
    window_->findChild<QComboBox*>("cloudSamples")->setCurrentIndex(sample);
    EXPECT_TRUE(read());
    return page().cloud(desktop::CloudSource::Measured);
  };
  const auto* cloud = frames(1);
  const auto first = std::count(cloud->detections.frame.begin(), cloud->detections.frame.end(), 0);
  EXPECT_EQ(view().shownPoints(), cloud->size());
  window_->findChild<QComboBox*>("cloudFrames")->setCurrentIndex(1);
  EXPECT_EQ(view().shownPoints(), std::size_t(first));
}

TEST_F(DesktopCloud, ACancelledSimulationShowsNothing) {
  ASSERT_TRUE(open(folder_ / "street"));
  page().chooseModel(folder_ / "dry.json");
  QSignalSpy cancelled(&page().runner(), &desktop::SimulationRunner::cancelled);
  page().simulate();
  page().cancel();
  ASSERT_TRUE(cancelled.wait(120'000));
  EXPECT_EQ(page().cloud(desktop::CloudSource::Simulated), nullptr);
}

TEST_F(DesktopCloud, DraggingTurnsAndTheWheelZoomsAndFitComesBack) {
  ASSERT_TRUE(open(folder_ / "street"));
  const desktop::PickedPoint point{desktop::CloudSource::Measured, 0};
  const QPointF before = view().placeOf(point);
  QTest::mousePress(&view(), Qt::LeftButton, {}, QPoint(200, 200));
  QTest::mouseMove(&view(), QPoint(260, 230));
  QTest::mouseRelease(&view(), Qt::LeftButton, {}, QPoint(260, 230));
  QTest::keyClick(&view(), Qt::Key_Plus);
  EXPECT_GT((view().placeOf(point) - before).manhattanLength(), 5);
  EXPECT_FALSE(view().picked());  // a drag is no click
  view().look(desktop::CloudView::Look::Perspective);
  EXPECT_LT((view().placeOf(point) - before).manhattanLength(), 1);
}

// Two beams on a wall 8 m away: a spot in the middle, neither two specks at the edge nor one point.
TEST_F(DesktopCloud, ASampleOfFewPointsOpensFittedAndStaysSo) {
  ASSERT_TRUE(open(folder_ / "foggy-sweep"));
  const auto wellFramed = [this] { return farthestOut() > 0.1 && farthestOut() < 0.9; };
  EXPECT_TRUE(wellFramed()) << farthestOut();
  window_->resize(1000, 900);
  desktop::settle(*window_);
  EXPECT_TRUE(wellFramed()) << farthestOut();
  QTest::keyClick(&view(), Qt::Key_Plus);
  EXPECT_FALSE(view().isFitted());
  window_->findChild<QComboBox*>("cloudSamples")->setCurrentIndex(2);
  ASSERT_TRUE(read());
  EXPECT_TRUE(view().isFitted());
  EXPECT_TRUE(wellFramed()) << farthestOut();
}

TEST_F(DesktopCloud, ABrokenExperimentSaysWhereWhatAndWhatToDoInItsPlace) {
  ASSERT_TRUE(open(folder_ / "street"));
  const auto broken = folder_.write("broken/experiment.json", "{ \"format\": ");
  EXPECT_FALSE(page().openExperiment(broken));
  EXPECT_EQ(view().shownPoints(), 0u);
  EXPECT_TRUE(view().message().contains("What to do"));
  const QString text = child<QTextBrowser>("cloudValues")->toPlainText();
  EXPECT_TRUE(text.contains("broken") && text.contains("Where")) << text.toStdString();
  ASSERT_TRUE(open(folder_ / "street"));  // and all is well again
  EXPECT_GT(view().shownPoints(), 0u);
  EXPECT_TRUE(page().readoutText().isEmpty());
}

TEST_F(DesktopCloud, MeasurementsThatCannotBeReadAreSaidInTheirPlace) {
  const model::Experiment street = model::readExperiment(folder_ / "street");
  std::ofstream(street.samples[0].measurements) << "frame,range_m\n0,far\n";
  ASSERT_TRUE(page().openExperiment(folder_ / "street"));
  ASSERT_TRUE(read());
  EXPECT_EQ(view().shownPoints(), 0u);
  EXPECT_TRUE(page().readoutText().contains("What to do")) << page().readoutText().toStdString();
  EXPECT_TRUE(page().readoutText().contains(QString::fromStdString(street.samples[0].measurements.filename())));
}

TEST_F(DesktopCloud, AnExperimentWithoutMeasurementsSaysSoAndCanBeSimulated) {
  ASSERT_TRUE(open(folder_ / "truth"));
  EXPECT_EQ(view().shownPoints(), 0u);
  EXPECT_TRUE(view().message().contains("Simulate"));
  page().chooseModel(folder_ / "dry.json");
  simulate();
  EXPECT_GT(view().shownPoints(), 0u);
}

// Fired beams are detected or shown among those without detection: together they are all beams.
TEST_F(DesktopCloud, EveryBeamWithoutDetectionIsShownAndSaysWhy) {
  ASSERT_TRUE(open(folder_ / "street"));
  page().chooseModel(folder_ / "dry.json");
  simulate();
  child<QCheckBox>("cloudSilent")->setChecked(true);
  ASSERT_TRUE(QTest::qWaitFor([this] { return page().cloud(desktop::CloudSource::Silent) != nullptr; }, 60'000));
  const auto& silent = *page().cloud(desktop::CloudSource::Silent);
  const auto& simulated = page().cloud(desktop::CloudSource::Simulated)->detections;
  std::set<std::pair<int, long>> detected;
  for (std::size_t i = 0; i < simulated.size(); ++i) {
    detected.insert({simulated.layer[i], std::lround(1e6 * simulated.azimuth_rad[i])});
  }
  const model::Experiment street = model::readExperiment(folder_ / "street");
  EXPECT_EQ(detected.size() + silent.size(), model::beamsFired(street, street.samples[0]).size());
  view().pick(desktop::PickedPoint{desktop::CloudSource::Silent, silent.size() / 2});
  EXPECT_TRUE(page().readoutText().contains("Reason\t"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return page().waveform().beam().has_value(); }, 60'000));
  EXPECT_NE(page().waveform().beam()->reason, model::Reason::kDetected);
  EXPECT_TRUE(page().readoutText().contains("Threshold")) << page().readoutText().toStdString();
}

TEST_F(DesktopCloud, KeysPickStepAndCopyTheValues) {
  ASSERT_TRUE(open(folder_ / "street"));
  QTest::keyClick(&view(), Qt::Key_N);
  ASSERT_TRUE(view().picked());
  EXPECT_EQ(view().picked()->index, 0u);
  QTest::keyClick(&view(), Qt::Key_N);
  EXPECT_EQ(view().picked()->index, 1u);
  QTest::keyClick(&view(), Qt::Key_P);
  EXPECT_EQ(view().picked()->index, 0u);
  QTest::keyClick(&view(), Qt::Key_C, Qt::ControlModifier);
  const double range = page().cloud(desktop::CloudSource::Measured)->detections.range_m[0];
  EXPECT_TRUE(QApplication::clipboard()->text().contains("Range\t" + QString::number(range, 'f', 3) + " m"));
  QTest::keyClick(&view(), Qt::Key_Escape);
  QTest::keyClick(&view(), Qt::Key_Space);
  EXPECT_TRUE(view().picked());
}

// The simulation that was stopped is waited for, then the new one comes.
TEST_F(DesktopCloud, SimulatingAgainWhileTheOldOneStopsStartsWhenItHasStopped) {
  ASSERT_TRUE(open(folder_ / "street"));
  page().chooseModel(folder_ / "dry.json");
  page().simulate();
  page().cancel();
  QSignalSpy finished(&page().runner(), &desktop::SimulationRunner::finished);
  page().simulate();
  ASSERT_TRUE(finished.wait(120'000));
  EXPECT_NE(page().cloud(desktop::CloudSource::Simulated), nullptr);
}

TEST_F(DesktopCloud, AThumbingThroughSamplesEndsWithTheLast) {
  ASSERT_TRUE(open(folder_ / "street"));
  for (const int sample : {1, 0, 1, 0, 1}) window_->findChild<QComboBox*>("cloudSamples")->setCurrentIndex(sample);
  ASSERT_TRUE(read());
  const model::Experiment street = model::readExperiment(folder_ / "street");
  EXPECT_EQ(page().cloud(desktop::CloudSource::Measured)->size(),
            model::readMeasurements(street, street.samples[1]).size());
}

// Says how long a frame takes; how long it may take depends on the machine.
TEST_F(DesktopCloud, AMillionPointsAreDrawn) {
  constexpr std::size_t kPoints = 1'000'000;
  core::Detections d{.frame = {}, .layer = {}, .azimuth_rad = {}, .elevation_rad = {}, .echo = {}, .range_m = {}};
  for (std::size_t i = 0; i < kPoints; ++i) {
    const double turn = double(i) / double(kPoints);
    d.frame.push_back(0);
    d.layer.push_back(int(i % 128));
    d.azimuth_rad.push_back(6.2 * turn - 3.1);
    d.elevation_rad.push_back(0.4 * double(i % 128) / 128.0 - 0.3);
    d.echo.push_back(1);
    d.range_m.push_back(20.0 + 15.0 * std::sin(40.0 * turn));
  }
  ASSERT_TRUE(open(folder_ / "truth"));
  view().setCloud(desktop::CloudSource::Measured,
                  std::make_shared<const desktop::PointCloud>(desktop::pointCloudOf(std::move(d))));
  EXPECT_EQ(view().shownPoints(), kPoints);
  for (const auto colour : {desktop::ColourBy::Source, desktop::ColourBy::Range}) {
    view().setColourBy(colour);
    view().repaint();
    QElapsedTimer clock;
    clock.start();
    for (int k = 0; k < 20; ++k) {
      QTest::keyClick(&view(), Qt::Key_Left);
      view().repaint();
    }
    std::cout << "a frame of a million points at " << view().width() << " x " << view().height() << ": "
              << double(clock.elapsed()) / 20.0 << " ms\n";
  }
}

TEST_F(DesktopCloud, PicturesOfTheStreet) {
  ASSERT_TRUE(open(folder_ / "street"));
  page().chooseModel(folder_ / "dry.json");
  simulate();
  const std::filesystem::path pictures = std::filesystem::path(FIDELIS_SCREENSHOTS) / "light";
  std::filesystem::create_directories(pictures);
  const auto shoot = [&](const std::string& name) {
    desktop::settle(*window_);
    EXPECT_TRUE(window_->grab().save(QString::fromStdString((pictures / (name + ".png")).string())));
  };
  view().pick(
      desktop::PickedPoint{desktop::CloudSource::Measured, page().cloud(desktop::CloudSource::Measured)->size() / 2});
  shoot("point-cloud-overlay");
  window_->findChild<QComboBox*>("cloudColour")->setCurrentIndex(int(desktop::ColourBy::Range));
  window_->findChild<QCheckBox*>("cloudSimulated")->setChecked(false);
  shoot("point-cloud-range");
  window_->findChild<QCheckBox*>("cloudSimulated")->setChecked(true);
  window_->findChild<QComboBox*>("cloudColour")->setCurrentIndex(int(desktop::ColourBy::Source));
  view().look(desktop::CloudView::Look::Top);
  shoot("point-cloud-top");
}

TEST_F(DesktopCloud, PicturesInLightAndDarkOfSmallAndLargeWindows) {
  folder_.write("a folder with quite a long name, as they come from a measuring campaign/experiment.json", "[");
  const std::filesystem::path pictures = std::filesystem::path(FIDELIS_SCREENSHOTS) / "point-cloud";
  std::filesystem::create_directories(pictures);
  for (const bool dark : {false, true}) {
    QApplication::setPalette(dark ? desktop::darkPalette() : desktop::lightPalette());
    for (const QSize size : {QSize(1280, 800), QSize(1920, 1080)}) {
      window_->resize(size);
      const auto shoot = [&](const std::string& name) {
        desktop::settle(*window_);
        const std::string file = name + (dark ? "-dark-" : "-light-") + std::to_string(size.width()) + ".png";
        EXPECT_TRUE(window_->grab().save(QString::fromStdString((pictures / file).string())));
      };
      ASSERT_TRUE(open(folder_ / "foggy-sweep"));
      shoot("opening");
      ASSERT_TRUE(open(folder_ / "street"));
      page().chooseModel(folder_ / "dry.json");
      simulate();
      child<QComboBox>("cloudColour")->setCurrentIndex(int(desktop::ColourBy::Difference));
      view().pick(desktop::PickedPoint{desktop::CloudSource::Measured, 5000});
      ASSERT_TRUE(QTest::qWaitFor([&] { return page().waveform().beam().has_value(); }, 60'000));
      shoot("beam");
      child<QComboBox>("cloudColour")->setCurrentIndex(int(desktop::ColourBy::Source));
      child<QCheckBox>("cloudSilent")->setChecked(true);
      ASSERT_TRUE(QTest::qWaitFor([this] { return page().cloud(desktop::CloudSource::Silent) != nullptr; }, 60'000));
      view().pick(desktop::PickedPoint{desktop::CloudSource::Silent, 0});
      ASSERT_TRUE(QTest::qWaitFor([&] { return page().waveform().beam().has_value(); }, 60'000));
      shoot("no-detection");
      child<QCheckBox>("cloudSilent")->setChecked(false);
      page().openExperiment(folder_ / "a folder with quite a long name, as they come from a measuring campaign" /
                            "experiment.json");
      shoot("error");
      EXPECT_LE(window_->width(), size.width());  // nothing pushes the window apart
    }
  }
  QApplication::setPalette(desktop::lightPalette());
}

// What the words say must be readable on what they stand on: WCAG 2.1 asks for 4.5 : 1.
TEST(Colours, TextIsReadableInLightAndInDark) {
  using namespace desktop;
  for (const QPalette& palette : {lightPalette(), darkPalette()}) {
    const QColor base = palette.color(QPalette::Base);
    EXPECT_GE(contrast(muted(palette), base), 4.5);
    EXPECT_GE(contrast(palette.color(QPalette::Link), base), 4.5);
    for (const QColor& accent : {accent::kBlue, accent::kOrange, accent::kTeal, accent::kRed, accent::kPurple}) {
      EXPECT_GE(contrast(readable(palette, accent), base), 4.5) << accent.name().toStdString();
    }
    for (int score = 1; score <= 10; ++score) {
      EXPECT_GE(contrast(palette.color(QPalette::Text), weightColour(palette, score, 10)), 4.5) << score;
    }
  }
}

TEST_F(Desktop, PicturesOfEveryTabInLightAndDark) {
  QSignalSpy finished(&window_->resultsPage().runner(), &desktop::TestRunner::finished);
  window_->resultsPage().runAll();
  ASSERT_TRUE(finished.wait(300'000));
  const std::filesystem::path pictures = FIDELIS_SCREENSHOTS;
  QApplication::setPalette(desktop::lightPalette());
  desktop::renderTabs(*window_, pictures / "light");
  window_->graphPage().showNode(graph().node(graph().children(graph().phenomena()[0])[0]).id);
  window_->showTab(MainWindow::Graph);
  desktop::settle(*window_);
  window_->grab().save(QString::fromStdString((pictures / "light" / "graph-chains.png").string()));
  QTest::keyClicks(child<QLineEdit>("graphSearch"), "echo");
  QTest::qWait(100);
  window_->grab().save(QString::fromStdString((pictures / "light" / "graph-search.png").string()));
  MainWindow start(*settings_);
  start.show();
  desktop::settle(start);
  start.grab().save(QString::fromStdString((pictures / "light" / "start.png").string()));
  QApplication::setPalette(desktop::darkPalette());
  desktop::renderTabs(*window_, pictures / "dark");
  QApplication::setPalette(desktop::lightPalette());
  for (const char* name : {"graph", "relevance", "specification", "results", "point-cloud"}) {
    EXPECT_GT(std::filesystem::file_size(pictures / "light" / (std::string(name) + ".png")), 10'000u);
  }
}

}  // namespace

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QApplication::setStyle("Fusion");
  QApplication::setPalette(desktop::lightPalette());
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
