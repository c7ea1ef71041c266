#include "tests/widgets/gui_fixture.h"
#include "tests/widgets/parameters/parameter_specs.h"
#include "widgets/controls/message_bar.h"
#include "widgets/parameters/parameter_delegate.h"
#include "widgets/parameters/parameter_filter_model.h"
#include "widgets/parameters/parameter_table.h"
#include "widgets/parameters/parameter_table_model.h"

#include <QAbstractItemModelTester>
#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTreeView>
#include <QtTest/QTest>

#include <limits>

namespace halbench::widgets {
namespace {

using Model = ParameterTableModel;

class ParameterTableTest : public GuiTest {
protected:
    void fill(Model& model) {
        model.setSpecs(someSpecs());
        model.setDeviceValues(someValues(), Model::Origin::Read);
    }
    QString cell(const Model& model, const char* name, int column, int role = Qt::DisplayRole) {
        return model.indexOf(name).siblingAtColumn(column).data(role).toString();
    }
};

TEST_F(ParameterTableTest, modelKeepsTheRulesOfItemModels) {
    Model model;
    ParameterFilterModel filter;
    filter.setSourceModel(&model);
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
    QAbstractItemModelTester filterTester(&filter, QAbstractItemModelTester::FailureReportingMode::Fatal);
    fill(model);
    ASSERT_TRUE(model.edit("gain.kp", 12.0));
    filter.setChangedOnly(true);
    model.undoStack().undo();
    filter.setChangedOnly(false);
}

TEST_F(ParameterTableTest, showsDeviceEditedAndDefaultInGroups) {
    Model model;
    fill(model);
    EXPECT_EQ(model.rowCount(), 3);
    EXPECT_EQ(model.index(0, 0).data().toString(), QStringLiteral("Gains"));
    ASSERT_TRUE(model.edit("gain.kp", 12.5));
    EXPECT_EQ(cell(model, "gain.kp", Model::DeviceColumn), QStringLiteral("10"));
    EXPECT_EQ(cell(model, "gain.kp", Model::EditedColumn), QStringLiteral("12.5"));
    EXPECT_EQ(cell(model, "gain.kp", Model::DefaultColumn), QStringLiteral("10"));
    EXPECT_EQ(cell(model, "gain.kp", Model::UnitColumn), QStringLiteral("A/rad"));
    EXPECT_EQ(cell(model, "decode.method", Model::EditedColumn), QStringLiteral("arctangent"));
    EXPECT_EQ(cell(model, "stray.enabled", Model::EditedColumn), QStringLiteral("on"));
    EXPECT_TRUE(
        cell(model, "gain.kp", Model::EditedColumn, Qt::AccessibleTextRole).contains(QStringLiteral("12.5")));
    ASSERT_EQ(model.changedValues().size(), 1U);
    EXPECT_EQ(model.changedValues()[0].name, "gain.kp");
}

TEST_F(ParameterTableTest, refusesWhatTheOneCheckRefusesAndSaysWhatIsAllowed) {
    Model model;
    fill(model);
    QStringList refusals;
    std::optional<double> suggested;
    QObject::connect(
        &model, &Model::editRefused, &model,
        [&](const QString&, const QString& message, const QString& remedy, std::optional<double> suggestion) {
            refusals << message + remedy;
            suggested = suggestion;
        });
    const QModelIndex kp = model.indexOf("gain.kp");
    for (const char* text : {"nan", "inf", "", "ten"}) {
        EXPECT_FALSE(model.setData(kp, QLatin1String(text)));
        EXPECT_FALSE(suggested.has_value());
    }
    EXPECT_FALSE(model.setData(kp, QStringLiteral("2000")));
    EXPECT_TRUE(refusals.last().contains(QStringLiteral("1000")));
    EXPECT_EQ(suggested, 1000.0);
    EXPECT_FALSE(model.setData(model.indexOf("decode.method"), QStringLiteral("0.5")));
    EXPECT_FALSE(model.setData(model.indexOf("limit.current"), QStringLiteral("3")));
    EXPECT_EQ(model.edit("gain.kp", std::numeric_limits<double>::quiet_NaN()).error().code,
              ErrorCode::NotFinite);
    EXPECT_EQ(model.edit("gain.kx", 1.0).error().code, ErrorCode::UnknownName);
    EXPECT_EQ(model.changedCount(), 0);
    EXPECT_FALSE(model.flags(model.indexOf("limit.current")).testFlag(Qt::ItemIsEditable));
}

TEST_F(ParameterTableTest, undoGoesBackAlsoAfterTheEditWasWritten) {
    Model model;
    fill(model);
    ASSERT_TRUE(model.edit("gain.kp", 12.0));
    model.setDeviceValues({{"gain.kp", static_cast<double>(12.0F)}}, Model::Origin::Written);
    EXPECT_EQ(model.changedCount(), 0);
    model.undoStack().undo();
    ASSERT_EQ(model.changedCount(), 1); // the old value is proposed, not written behind the user's back
    EXPECT_EQ(model.changedValues()[0].value, 10.0);
    model.undoStack().redo();
    EXPECT_EQ(model.changedCount(), 0);
}

TEST_F(ParameterTableTest, revertAndDefaultsAreOneStepEach) {
    Model model;
    fill(model);
    ASSERT_TRUE(model.edit("gain.kp", 12.0));
    ASSERT_TRUE(model.edit("gain.ki", 0.5));
    model.revert();
    EXPECT_EQ(model.changedCount(), 0);
    model.undoStack().undo();
    EXPECT_EQ(model.changedCount(), 2);
    model.editToDefaults();
    // gains are back at what the device holds; the switch (default 0, device 1) is the only change
    ASSERT_EQ(model.changedCount(), 1);
    EXPECT_EQ(model.changedValues()[0].name, "stray.enabled");
    model.undoStack().undo();
    EXPECT_EQ(model.changedCount(), 2);
}

TEST_F(ParameterTableTest, showsAValueThatChangedBehindItsBack) {
    Model model;
    fill(model);
    ASSERT_TRUE(model.edit("gain.ki", 0.5));
    model.setDeviceValues({{"gain.kp", 20.0}}, Model::Origin::Read);
    const QModelIndex kp = model.indexOf("gain.kp").siblingAtColumn(Model::DeviceColumn);
    EXPECT_TRUE(kp.data(Model::OutsideRole).toBool());
    EXPECT_TRUE(kp.data(Qt::ToolTipRole).toString().contains(QStringLiteral("10 before")));
    EXPECT_EQ(cell(model, "gain.kp", Model::EditedColumn), QStringLiteral("20")); // no stale copy to write
    EXPECT_EQ(model.changedCount(), 1);
    model.acknowledgeOutsideChanges();
    EXPECT_FALSE(kp.data(Model::OutsideRole).toBool());
    model.setDeviceValues({{"gain.ki", 0.5}}, Model::Origin::Written);
    EXPECT_FALSE(model.indexOf("gain.ki").data(Model::OutsideRole).toBool());
}

TEST_F(ParameterTableTest, typesAndShowsDegreesButKeepsRadians) {
    Model model;
    fill(model);
    model.setAngleUnit(AngleUnit::Degree);
    EXPECT_EQ(cell(model, "gain.kp", Model::UnitColumn), QStringLiteral("A/°"));
    ASSERT_TRUE(model.setData(model.indexOf("gain.kp"), QStringLiteral("9 A/°")));
    ASSERT_TRUE(model.setData(model.indexOf("gain.kp"), QStringLiteral("10 A/deg"))); // as files write it
    // resources/help/htm-theory.md section 10, 12; the figure has six digits
    EXPECT_NEAR(model.changedValues()[0].value, 572.958, 5e-4);
}

TEST_F(ParameterTableTest, openingAndClosingAnEditorChangesNothing) {
    Model model;
    model.setSpecs(someSpecs());
    model.setDeviceValues({{"gain.kp", 1.0 / 3.0}}, Model::Origin::Read); // more digits than are shown
    const QModelIndex kp = model.indexOf("gain.kp");
    EXPECT_EQ(kp.data().toString(), QStringLiteral("0.33333"));
    EXPECT_EQ(kp.data(Qt::EditRole).toString(), QStringLiteral("0.3333333")); // who edits sees all that count
    EXPECT_TRUE(model.setData(kp, kp.data(Qt::EditRole)));
    EXPECT_EQ(model.changedCount(), 0);
    EXPECT_FALSE(model.undoStack().canUndo());
}

TEST_F(ParameterTableTest, searchFindsWordsOfNameHelpAndGroup) {
    Model model;
    fill(model);
    ParameterFilterModel filter;
    filter.setSourceModel(&model);
    filter.setSearch(QStringLiteral("integral LOOP"));
    ASSERT_EQ(filter.rowCount(), 1);
    EXPECT_EQ(filter.rowCount(filter.index(0, 0)), 1);
    filter.setSearch(QStringLiteral("nothing like it"));
    EXPECT_EQ(filter.rowCount(), 0);
}

class ParameterTableWidget : public ParameterTableTest {
protected:
    void SetUp() override {
        ParameterTableTest::SetUp();
        m_table = std::make_unique<ParameterTable>();
        m_table->setSpecs(someSpecs());
        m_table->model().setDeviceValues(someValues(), Model::Origin::Read);
        m_table->setOnline(true);
        m_table->resize(700, 500);
        m_table->show();
        QApplication::setActiveWindow(m_table.get());
        m_view = m_table->findChild<QTreeView*>();
        m_view->setFocus();
    }
    void TearDown() override {
        m_table.reset();
        ParameterTableTest::TearDown();
    }
    void select(const char* name) {
        auto* filter = qobject_cast<ParameterFilterModel*>(m_view->model());
        m_view->setCurrentIndex(filter->mapFromSource(m_table->model().indexOf(name)));
    }

    std::unique_ptr<ParameterTable> m_table;
    QTreeView* m_view = nullptr;
};

TEST_F(ParameterTableWidget, editsWritesAndUndoesByKeyboardAlone) {
    std::vector<ParameterValue> written;
    QObject::connect(m_table.get(), &ParameterTable::writeRequested, m_table.get(),
                     [&written](const std::vector<ParameterValue>& values) { written = values; });
    select("gain.kp");
    QTest::keyClick(m_view, Qt::Key_F2);
    auto* editor = m_view->findChild<QLineEdit*>();
    ASSERT_NE(editor, nullptr);
    QTest::keyClicks(editor, QStringLiteral("25"));
    QTest::keyClick(editor, Qt::Key_Return, Qt::ControlModifier); // the open editor is written too
    ASSERT_EQ(written.size(), 1U);
    EXPECT_EQ(written[0].value, 25.0);
    QTest::keyClick(m_view, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(m_table->model().changedCount(), 0);
    QTest::keyClick(m_view, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_EQ(m_table->model().changedCount(), 1);
}

TEST_F(ParameterTableWidget, choosesAnEnumerationFromAList) {
    select("decode.method");
    QTest::keyClick(m_view, Qt::Key_F2);
    auto* combo = m_view->findChild<QComboBox*>();
    ASSERT_NE(combo, nullptr);
    EXPECT_EQ(combo->count(), 2);
    combo->setCurrentIndex(1);
    QTest::keyClick(combo, Qt::Key_Return);
    m_view->setFocus();
    EXPECT_EQ(m_table->model().changedCount(), 1);
}

TEST_F(ParameterTableWidget, refusalStandsInPlaceWithItsRemedyAsAButton) {
    m_table->model().setData(m_table->model().indexOf("gain.kp"), QStringLiteral("5000"));
    ASSERT_TRUE(m_table->messages().isVisible());
    auto* remedy = m_table->messages().findChild<QPushButton*>();
    EXPECT_EQ(remedy->text(), QStringLiteral("Use 1000"));
    remedy->click();
    ASSERT_EQ(m_table->model().changedCount(), 1);
    EXPECT_EQ(m_table->model().changedValues()[0].value, 1000.0);
    EXPECT_FALSE(m_table->messages().isVisible());
}

TEST_F(ParameterTableWidget, refusalStaysWhileValuesAreReadAgain) {
    m_table->model().setData(m_table->model().indexOf("gain.kp"), QStringLiteral("5000"));
    QSignalSpy changes(&m_table->model(), &Model::dataChanged);
    m_table->model().setDeviceValues(someValues(), Model::Origin::Read);
    EXPECT_TRUE(m_table->messages().isVisible());
    EXPECT_EQ(changes.count(), 0); // polling the same values repaints nothing
    m_table->model().setDeviceValues({{"gain.ki", 0.3}}, Model::Origin::Read);
    EXPECT_TRUE(m_table->messages().isVisible());
    EXPECT_EQ(changes.count(), 1);
}

TEST_F(ParameterTableWidget, withoutADeviceNothingIsWrittenOrReadButEditsStay) {
    ASSERT_TRUE(m_table->model().edit("gain.kp", 12.0));
    m_table->setOnline(false);
    QSignalSpy reads(m_table.get(), &ParameterTable::readRequested);
    QTest::keyClick(m_view, Qt::Key_F5);
    EXPECT_EQ(reads.count(), 0);
    EXPECT_EQ(m_table->model().changedCount(), 1);
    m_table->setOnline(true);
    QTest::keyClick(m_view, Qt::Key_F5);
    EXPECT_EQ(reads.count(), 1);
}

TEST_F(ParameterTableWidget, everyControlHasANameAndATooltip) {
    for (const QWidget* widget : m_table->findChildren<QWidget*>()) {
        const bool isControl = qobject_cast<const QAbstractButton*>(widget) != nullptr ||
                               (qobject_cast<const QComboBox*>(widget) != nullptr) || widget == m_view;
        if (isControl && widget->isVisible() && widget->focusPolicy() != Qt::NoFocus) {
            const auto* button = qobject_cast<const QAbstractButton*>(widget);
            EXPECT_FALSE(widget->accessibleName().isEmpty() &&
                         (button == nullptr || button->text().isEmpty()))
                << widget->metaObject()->className();
            const bool isHiddenAction = button != nullptr && button->text().isEmpty();
            EXPECT_TRUE(isHiddenAction || !widget->toolTip().isEmpty()) << widget->metaObject()->className();
        }
    }
}

} // namespace
} // namespace halbench::widgets
