#include "app/workbench/recording_control.h"
#include "app/workspaces/recordings/import_table.h"
#include "app/workspaces/recordings/import_text.h"
#include "app/workspaces/recordings/import_view.h"
#include "devices/formats/recording_file.h"
#include "tests/app/workspaces/bench_fixture.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/quantity_edit.h"

#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTemporaryDir>

#include <cmath>

namespace halbench::app {
namespace {

class ImportViewTest : public BenchTest {
protected:
    void SetUp() override {
        BenchTest::SetUp();
        bench().recording().setFolder(folder.path());
        view = std::make_unique<ImportView>(bench());
        view->resize(1000, 600);
        view->show();
        QObject::connect(view.get(), &ImportView::imported, view.get(),
                         [this](const QString& path) { imported = path; });
    }
    void TearDown() override { view.reset(); }

    QString table(const QByteArray& text, const QString& name = "log.txt") {
        QFile file(folder.filePath(name));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text);
        return file.fileName();
    }
    /// Until it is said what of it is missing, or that nothing is.
    void look(const QByteArray& text) {
        view->begin(table(text));
        settle();
    }
    void settle() {
        ASSERT_TRUE(wait([this] { return !reason().contains("Reading the file"); }));
    }
    QPushButton& button() { return *find<QPushButton>(*view, "Import"); }
    QString reason() { return find<QLabel>(*view, "Missing for the import")->text(); }
    QComboBox* question() {
        for (auto* row : view->findChildren<QuestionRow*>()) {
            if (row->isVisible()) {
                return row->findChild<QComboBox*>();
            }
        }
        return nullptr;
    }
    void choose(QComboBox& box, int index) {
        box.setCurrentIndex(index);
        Q_EMIT box.activated(index);
        settle();
    }
    ImportTable& rows() { return *find<ImportTable>(*view, "Preview of the first rows"); }
    /// Of the table itself, below what is said of its columns.
    QString cell(int row, int column) {
        const QTableWidgetItem* title = rows().verticalHeaderItem(0);
        const int first = title != nullptr && title->text() == "Name" ? FirstRow : 0;
        return rows().item(row + first, column)->text();
    }
    QString header(int column) { return rows().horizontalHeaderItem(column)->text(); }
    /// As by keyboard: on the cell, typed over what is there, and confirmed.
    void write(int row, int column, const QString& text) {
        rows().setFocus();
        rows().setCurrentCell(row, column);
        QTest::keyClick(&rows(), Qt::Key_F2);
        auto* editor = qobject_cast<QLineEdit*>(rows().indexWidget(rows().currentIndex()));
        ASSERT_NE(editor, nullptr);
        EXPECT_FALSE(editor->accessibleName().isEmpty());
        type(editor, text);
        QTest::keyClick(editor, Qt::Key_Return);
        QCoreApplication::processEvents(); // the delegate commits after the key
        settle();
    }
    void takeBack(int row, int column) {
        rows().setCurrentCell(row, column);
        QTest::keyClick(&rows(), Qt::Key_Delete);
        settle();
    }
    bool isSaid(int row, int column) { return rows().item(row, column)->font().bold(); }
    widgets::Message message() { return view->findChild<widgets::MessageBar*>()->message(); }
    Recording import() {
        QTest::mouseClick(&button(), Qt::LeftButton);
        EXPECT_TRUE(wait([this] { return !imported.isEmpty(); })) << message().text.toStdString();
        const auto read = devices::readRecordingFile(imported.toStdString());
        EXPECT_TRUE(read);
        return read ? read->recording : Recording();
    }

    static constexpr int NameRow = 0;
    static constexpr int UnitRow = 1;
    static constexpr int FirstRow = 2;
    QTemporaryDir folder;
    QString imported;
    std::unique_ptr<ImportView> view;
};

TEST_F(ImportViewTest, showsTheFirstRowsAsTheyWouldBeReadAndImportsThem) {
    EXPECT_FALSE(button().isEnabled());
    EXPECT_TRUE(reason().startsWith("Choose a file")) << reason().toStdString();
    look("t_ms;speed [rpm];Last [stone]\n0;30;1,25\n10;60;1,5\n20;90;1,75\n");
    EXPECT_TRUE(button().isEnabled()) << reason().toStdString();
    EXPECT_EQ(header(0), "time [s]\nfrom t_ms");
    EXPECT_EQ(header(1), "speed [rad/s]\nfrom speed [rpm]");
    EXPECT_TRUE(header(2).contains("unit not known")) << header(2).toStdString();
    EXPECT_EQ(cell(1, 0), "0.01");
    EXPECT_EQ(cell(1, 1).left(6), "6.2831"); // 60 r/min are a turn a second
    EXPECT_EQ(cell(2, 2), "1.75");
    EXPECT_EQ(find<QComboBox>(*view, "Separator")->currentText(), "detected: semicolon");
    EXPECT_EQ(find<QComboBox>(*view, "Decimal sign")->currentText(), "detected: comma");
    const Recording recording = import();
    ASSERT_EQ(recording.rows(), 3U);
    EXPECT_DOUBLE_EQ(recording.time_s[2], 0.02);
    EXPECT_DOUBLE_EQ(recording.values[0], M_PI); // the nearest double times 2 pi / 60
    EXPECT_DOUBLE_EQ(recording.values[1], 1.25);
    EXPECT_EQ(imported, folder.filePath("log.csv"));
    EXPECT_TRUE(message().text.contains("3 rows")) << message().text.toStdString();
    EXPECT_TRUE(message().remedy.contains("stone"))
        << message().remedy.toStdString(); // what is doubtful of it
    EXPECT_FALSE(button().isEnabled());
}

/// "1,5" in a single column is two numbers or 1.5.
TEST_F(ImportViewTest, whatIsAmbiguousIsAskedAndEachAnswerIsRead) {
    const QByteArray text = "1,5\n2,5\n3,5\n";
    look(text);
    EXPECT_FALSE(button().isEnabled());
    EXPECT_TRUE(reason().startsWith("Answer above")) << reason().toStdString();
    ASSERT_NE(question(), nullptr);
    ASSERT_EQ(question()->count(), 3); // Please choose, and two answers
    EXPECT_EQ(cell(0, 0), "1,5");      // as it is
    choose(*question(), 0);
    EXPECT_FALSE(button().isEnabled()) << "nothing was answered";
    int columns = 0;
    for (const int answer : {1, 2}) {
        imported.clear();
        look(text);
        choose(*question(), answer);
        ASSERT_NE(question(), nullptr) << "where the time is"; // neither has a column of that name
        choose(*question(), question()->count() - 1);
        EXPECT_FALSE(button().isEnabled());
        EXPECT_TRUE(reason().contains("sampling rate")) << reason().toStdString();
        auto* rate = find<widgets::QuantityEdit>(*view, "Sample rate");
        EXPECT_TRUE(rate->isEnabled());
        type(rate, "100");
        QTest::keyClick(rate, Qt::Key_Return);
        settle();
        ASSERT_TRUE(button().isEnabled()) << reason().toStdString();
        const Recording recording = import();
        ASSERT_EQ(recording.rows(), 3U);
        EXPECT_DOUBLE_EQ(recording.time_s[1], 0.01);
        const std::size_t width = recording.layout->columns.size();
        columns += static_cast<int>(width);
        EXPECT_DOUBLE_EQ(recording.values[0], width == 1 ? 1.5 : 1.0);
    }
    EXPECT_EQ(columns, 3);
    EXPECT_TRUE(QFile::exists(folder.filePath("log-2.csv"))); // no recording is overwritten
}

TEST_F(ImportViewTest, aUnitThatIsNowhereIsAsked) {
    look("time_s,speed\n0,30\n1,60\n");
    ASSERT_NE(question(), nullptr) << reason().toStdString();
    EXPECT_FALSE(button().isEnabled());
    EXPECT_EQ(cell(0, 1), "speed"); // its columns are known, what their numbers mean is not
    EXPECT_EQ(cell(2, 1), "60");
    choose(*question(), question()->findText("unit of its numbers: rpm"));
    ASSERT_TRUE(button().isEnabled()) << reason().toStdString();
    EXPECT_DOUBLE_EQ(import().values[0], M_PI);
}

/// The same request as `--map speed=Drehzahl --unit Drehzahl=rpm`.
TEST_F(ImportViewTest, columnsAreNamedAndTheirUnitSaidInTheTable) {
    look("t_s,Drehzahl,Strom [mA]\n0,30,1500\n1,60,2500\n");
    ASSERT_TRUE(button().isEnabled()) << reason().toStdString();
    EXPECT_EQ(rows().item(NameRow, 1)->text(), "Drehzahl");
    EXPECT_EQ(rows().item(UnitRow, 2)->text(), "mA");
    EXPECT_FALSE(rows().item(NameRow, 0)->flags() & Qt::ItemIsEditable) << "the time has its own field";
    EXPECT_EQ(rows().item(UnitRow, 2)->data(Qt::AccessibleTextRole).toString(),
              "Unit of column Strom [mA]: mA");
    write(UnitRow, 1, "rpm");
    write(NameRow, 1, "speed");
    write(NameRow, 2, "current_command");
    ASSERT_TRUE(button().isEnabled()) << reason().toStdString();
    EXPECT_TRUE(isSaid(NameRow, 1) && isSaid(UnitRow, 1) && isSaid(NameRow, 2));
    EXPECT_FALSE(isSaid(UnitRow, 2)) << "that was found";
    EXPECT_EQ(header(1), "speed [rad/s]\nfrom Drehzahl");
    const Recording recording = import();
    ASSERT_EQ(recording.layout->columns.size(), 2U);
    EXPECT_EQ(recording.layout->columns[0].name, "speed");
    EXPECT_EQ(recording.layout->columns[1].name, "current_command");
    EXPECT_DOUBLE_EQ(recording.values[0], M_PI); // 30 r/min
    EXPECT_DOUBLE_EQ(recording.values[1], 1.5);
}

TEST_F(ImportViewTest, whatWasSaidOfAColumnIsTakenBack) {
    look("time_s,speed,x\n0,30,1\n1,60,2\n");
    choose(*question(), question()->findText("unit of its numbers: rpm"));
    ASSERT_TRUE(button().isEnabled()) << reason().toStdString();
    EXPECT_EQ(rows().item(UnitRow, 1)->text(), "rpm");
    EXPECT_TRUE(isSaid(UnitRow, 1));
    write(UnitRow, 1, "deg/s");
    EXPECT_NEAR(cell(1, 1).toDouble(), M_PI / 3.0, 1e-8) << "60 deg/s; nine digits are shown";
    takeBack(UnitRow, 1);
    EXPECT_FALSE(button().isEnabled()) << "it is asked again";
    ASSERT_NE(question(), nullptr);
    EXPECT_EQ(rows().item(UnitRow, 1)->text(), "");
    choose(*question(), question()->findText("unit of its numbers: rad/s"));
    EXPECT_EQ(cell(1, 1), "60");
    write(NameRow, 2, "hall.a");
    ASSERT_NE(question(), nullptr) << "hall.a has a quantity, x has no unit";
    takeBack(NameRow, 2);
    EXPECT_EQ(rows().item(NameRow, 2)->text(), "x");
    EXPECT_FALSE(isSaid(NameRow, 2));
    EXPECT_TRUE(button().isEnabled()) << reason().toStdString();
}

TEST_F(ImportViewTest, whatCannotBeSaidIsRefusedInWordsOfTheWindowAndStaysToBeMended) {
    look("t_s,a [T],b\n0,1,2\n1,2,3\n");
    struct Wrong {
        int row;
        const char* text;
        const char* said;
    };
    for (const Wrong& wrong :
         {Wrong{NameRow, "9 lives", "not allowed as a signal name"}, Wrong{NameRow, "zeit", "it is the time"},
          Wrong{UnitRow, "furlong", "is not a known unit"},
          Wrong{NameRow, "speed", "is in T, but speed is in rad/s"}}) {
        write(wrong.row, 1, wrong.text);
        EXPECT_FALSE(button().isEnabled()) << wrong.text;
        EXPECT_TRUE(message().text.contains(wrong.said)) << message().text.toStdString();
        EXPECT_FALSE(message().text.contains("--")) << message().text.toStdString();
        EXPECT_FALSE(message().remedy.contains("--")) << message().remedy.toStdString();
        EXPECT_EQ(rows().item(wrong.row, 1)->text(), wrong.text) << "to be mended";
        takeBack(wrong.row, 1);
        EXPECT_TRUE(button().isEnabled()) << reason().toStdString();
    }
    write(NameRow, 1, "same");
    write(NameRow, 2, "same");
    EXPECT_TRUE(message().text.contains("given to two columns")) << message().text.toStdString();
    write(NameRow, 2, "other");
    EXPECT_TRUE(button().isEnabled()) << message().text.toStdString();
}

/// Two columns of one header are told apart by their number, and a count of rows shifts none of them.
TEST_F(ImportViewTest, columnsOfTheSameHeaderAndWithoutATimeAreNamed) {
    look("x,x\n1,2\n3,4\n");
    auto* time = find<QComboBox>(*view, "Time");
    choose(*time, time->findText("none: use a fixed sampling rate"));
    type(find<widgets::QuantityEdit>(*view, "Sample rate"), "10");
    QTest::keyClick(find<widgets::QuantityEdit>(*view, "Sample rate"), Qt::Key_Return);
    settle();
    ASSERT_TRUE(button().isEnabled()) << reason().toStdString() << message().text.toStdString();
    write(NameRow, 2, "second"); // the counted time stands before them
    write(NameRow, 1, "first");
    ASSERT_TRUE(button().isEnabled()) << message().text.toStdString();
    const Recording recording = import();
    EXPECT_EQ(recording.layout->columns[0].name, "first");
    EXPECT_EQ(recording.layout->columns[1].name, "second");
    EXPECT_DOUBLE_EQ(recording.values[1], 2.0);
}

TEST_F(ImportViewTest, otherColumnsForgetWhatWasSaidOfThem) {
    look("t_s;x\n0;1\n1;2\n");
    write(NameRow, 1, "mine");
    EXPECT_EQ(header(1).left(4), "mine");
    choose(*find<QComboBox>(*view, "Separator"), find<QComboBox>(*view, "Separator")->findText("comma"));
    EXPECT_FALSE(button().isEnabled());
    choose(*find<QComboBox>(*view, "Separator"), 0);
    ASSERT_TRUE(button().isEnabled()) << message().text.toStdString();
    EXPECT_EQ(rows().item(NameRow, 1)->text(), "x");
    EXPECT_FALSE(isSaid(NameRow, 1));
}

TEST_F(ImportViewTest, whatTheUserSaysGoesBeforeWhatWasFound) {
    look("t_s,x\n0,1\n1,2\n2,3\n");
    ASSERT_TRUE(button().isEnabled()) << reason().toStdString();
    choose(*find<QComboBox>(*view, "Time"), find<QComboBox>(*view, "Time")->findText("column x"));
    EXPECT_FALSE(button().isEnabled()) << "x has no unit";
    ASSERT_NE(question(), nullptr);
    choose(*question(), question()->findText("unit of its numbers: ms"));
    ASSERT_TRUE(button().isEnabled()) << reason().toStdString();
    EXPECT_EQ(cell(0, 1), "0.001");
    choose(*find<QComboBox>(*view, "Separator"), find<QComboBox>(*view, "Separator")->findText("semicolon"));
    EXPECT_FALSE(button().isEnabled());
}

TEST_F(ImportViewTest, anErrorSaysLineColumnAndRemedyOfTheWindow) {
    look("t_s,x\n0,1\n1,abc\n2,3\n");
    EXPECT_FALSE(button().isEnabled());
    EXPECT_TRUE(message().text.contains("log.txt:3:3")) << message().text.toStdString();
    EXPECT_FALSE(message().remedy.isEmpty());
    EXPECT_FALSE(message().remedy.contains("--")) << message().remedy.toStdString();
    QByteArray late = "t_s,x\n"; // behind all that the preview looks at
    for (int row = 0; row < 5000; ++row) {
        late += QByteArray::number(row) + (row == 4000 ? ",1.5,2\n" : ",1.5\n");
    }
    look(late);
    ASSERT_TRUE(button().isEnabled()) << reason().toStdString();
    QTest::mouseClick(&button(), Qt::LeftButton);
    ASSERT_TRUE(wait([this] { return !message().text.isEmpty(); }));
    EXPECT_TRUE(message().text.contains("log.txt:4002:")) << message().text.toStdString();
    EXPECT_FALSE(QFile::exists(folder.filePath("log.csv")));
    EXPECT_TRUE(button().isEnabled()); // it can be tried again
}

TEST_F(ImportViewTest, aNameThatIsTakenOrNoneHoldsItUp) {
    table("", "other.csv");
    look("t_s,x\n0,1\n1,2\n");
    auto* name = find<QLineEdit>(*view, "Name of the recording");
    EXPECT_EQ(name->text(), "log");
    for (const char* wrong : {"other", "", "a/b"}) {
        name->setText(wrong);
        EXPECT_FALSE(button().isEnabled()) << wrong;
        EXPECT_FALSE(reason().isEmpty());
    }
    name->setText("fine");
    EXPECT_TRUE(button().isEnabled());
    import();
    EXPECT_EQ(imported, folder.filePath("fine.csv"));
}

TEST_F(ImportViewTest, aFileThatIsNoTableOrIsNotThereIsSaid) {
    view->begin(folder.filePath("nowhere.csv"));
    settle();
    EXPECT_TRUE(message().text.contains("nowhere.csv")) << message().text.toStdString();
    EXPECT_FALSE(button().isEnabled());
    look(QByteArray("\0\1\2\3", 4));
    EXPECT_FALSE(message().text.isEmpty());
    EXPECT_FALSE(button().isEnabled());
    look("");
    EXPECT_FALSE(message().text.isEmpty());
    EXPECT_FALSE(button().isEnabled());
}

TEST(TableImport, cancelledItLeavesNothingBehind) {
    QTemporaryDir folder;
    std::string text = "t_s,x\n";
    for (int row = 0; row < 3000; ++row) {
        text += std::to_string(row) + ",1\n";
    }
    const auto look = lookAtTable(text, "log.txt", {});
    ASSERT_TRUE(look);
    EXPECT_EQ(look->first.rows(), 8U);
    ImportProgress progress;
    progress.isCancelled = true;
    const std::string path = folder.filePath("log.csv").toStdString();
    const auto done = importTable(text, "log.txt", look->plan, path, {}, progress);
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().code, ErrorCode::Interrupted);
    EXPECT_TRUE(QDir(folder.path()).isEmpty());
    progress.isCancelled = false;
    ASSERT_TRUE(importTable(text, "log.txt", look->plan, path, {}, progress));
    EXPECT_GE(progress.rows.load(), 3000U);
    EXPECT_TRUE(isOwnRecording(path).value());
    ASSERT_FALSE(importTable(text, "log.txt", look->plan, path, {}, progress)) << "never over another file";
}

} // namespace
} // namespace halbench::app
