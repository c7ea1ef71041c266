#include "app/documents/spectrum_table.h"
#include "app/workspaces/analysis/spectrum_panel.h"
#include "app/workspaces/analysis/xy_panel.h"
#include "control/base/units.h"
#include "tests/app/workspaces/bench_fixture.h"
#include "widgets/figure/figure_view.h"
#include "widgets/spectrogram/spectrogram_view.h"

#include <QAction>
#include <QFile>
#include <QTemporaryDir>

#include <cmath>

// What the spectrum and the XY panel show, as tables.

namespace halbench::app {
namespace {

class PictureDataTest : public BenchTest {
protected:
    template <typename Panel>
    Panel& show() {
        auto shown = std::make_unique<Panel>(bench());
        shown->setFileChooser(
            {[this](QWidget*, const FileQuestion&) { return folder.filePath("data.csv"); }, {}});
        shown->resize(900, 800);
        shown->show();
        Panel& panel = *shown;
        m_panel = std::move(shown);
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&panel));
        return panel;
    }
    void TearDown() override { m_panel.reset(); }
    void save() { QTest::keyClick(m_panel.get(), Qt::Key_E, Qt::ControlModifier | Qt::AltModifier); }
    QList<QByteArray> saved() {
        QFile file(folder.filePath("data.csv"));
        EXPECT_TRUE(wait([&] { return file.exists(); }));
        EXPECT_TRUE(file.open(QIODevice::ReadOnly));
        QList<QByteArray> lines = file.readAll().split('\n');
        lines.removeLast(); // behind the last line's end
        return lines;
    }
    static void press(QWidget& panel, const char* key) {
        for (QAction* action : panel.actions()) {
            if (action->shortcut() == QKeySequence(QLatin1String(key))) {
                action->trigger();
            }
        }
    }

    QTemporaryDir folder;
    std::unique_ptr<QWidget> m_panel;
};

/// 3 mT at 12.5 Hz for 4 s at 1 kHz: the line at 12.5 Hz has the amplitude, by theory.
TEST(SpectrumTable, isInSiWithTheUnitBehindTheNames) {
    std::vector<double> time_s;
    std::vector<double> values;
    for (int row = 0; row < 4000; ++row) {
        time_s.push_back(0.001 * row);
        values.push_back(0.003 * std::sin(2.0 * Pi * 12.5 * time_s.back()));
    }
    control::SpectrumConfig config;
    const auto spectrum = control::spectrum({time_s, values, "T"}, config);
    ASSERT_TRUE(spectrum);
    const QList<QByteArray> lines = QByteArray::fromStdString(spectrumTable(*spectrum, "T")).split('\n');
    EXPECT_EQ(lines[0], "frequency_Hz,value_T,low_T,high_T");
    ASSERT_EQ(lines.size(), 2002 + 1); // 0 to 500 Hz every 0.25 Hz, the header, behind the last end
    const QList<QByteArray> line = lines[51].split(',');
    EXPECT_DOUBLE_EQ(line[0].toDouble(), 12.5);
    EXPECT_NEAR(line[1].toDouble(), 0.003, 1e-9);
    config.scale = control::SpectrumScale::Density;
    config.segment_s = 1.0;
    const auto density = control::spectrogram({time_s, values, "T"}, config);
    ASSERT_TRUE(density);
    const QList<QByteArray> rows =
        QByteArray::fromStdString(spectrogramTable(*density, "T", config.scale)).split('\n');
    EXPECT_EQ(rows[0], "time_s,frequency_Hz,value_T_squared_per_Hz");
    EXPECT_EQ(static_cast<std::size_t>(rows.size()),
              density->time_s.size() * density->frequency_Hz.size() + 2);
}

TEST_F(PictureDataTest, theSpectrumIsSavedAsItIsShownInSi) {
    auto& panel = show<SpectrumPanel>();
    save(); // nothing is there yet, and nothing is asked
    connectTo("sim:htm", 5.0);
    auto* view = panel.findChild<widgets::FigureView*>();
    ASSERT_TRUE(wait([&] { return !view->isEmpty(); }));
    press(panel, "H");
    press(panel, "Y"); // linear: no line is left out
    const widgets::Curve curve = view->figure().panels.at(0).curves.at(0);
    save();
    const QList<QByteArray> lines = saved();
    EXPECT_EQ(lines[0], "frequency_Hz,value_rad_s,low_rad_s,high_rad_s");
    ASSERT_EQ(static_cast<std::size_t>(lines.size()), curve.x.size() + 1);
    for (const std::size_t i : {std::size_t{1}, curve.x.size() / 2, curve.x.size() - 1}) {
        const QList<QByteArray> cells = lines[static_cast<int>(i) + 1].split(',');
        EXPECT_DOUBLE_EQ(cells[0].toDouble(), curve.x[i]);
        EXPECT_NEAR(cells[1].toDouble() * 60.0 / (2.0 * Pi), curve.y[i], 1e-9 * curve.y[i]); // shown in r/min
    }
}

TEST_F(PictureDataTest, theSpectrogramIsSavedLineByLine) {
    auto& panel = show<SpectrumPanel>();
    press(panel, "O");
    connectTo("sim:htm", 5.0);
    ASSERT_TRUE(wait([&] { return !panel.findChild<widgets::SpectrogramView*>()->isEmpty(); }));
    save();
    const QList<QByteArray> lines = saved();
    EXPECT_EQ(lines[0], "time_s,frequency_Hz,value_rad_s");
    EXPECT_GT(lines.size(), 10);
    EXPECT_EQ(lines[1].split(',').size(), 3);
}

TEST_F(PictureDataTest, allPointsOfXyAreSavedNotOnlyThoseThatAreDrawn) {
    auto& panel = show<XyPanel>();
    connectTo("sim:htm", 5.0);
    auto* view = panel.findChild<widgets::FigureView*>();
    ASSERT_TRUE(
        wait([&] { return !view->isEmpty() && view->figure().panels.at(0).curves.at(0).x.size() > 1000; }));
    session().disconnectDevice(); // what is shown stays
    ASSERT_TRUE(wait([&] { return session().state() == SessionState::Disconnected; }));
    QTest::qWait(600); // the last question is answered
    const widgets::Curve drawn = view->figure().panels.at(0).curves.at(0);
    save();
    const QList<QByteArray> lines = saved();
    EXPECT_EQ(lines[0], "hall_a_T,hall_b_T");
    EXPECT_GE(static_cast<std::size_t>(lines.size()) - 1, drawn.x.size());
    const QList<QByteArray> last = lines.last().split(',');
    EXPECT_NEAR(1e3 * last[0].toDouble(), drawn.x.back(), 1e-9); // the newest is drawn; shown in mT
    EXPECT_NEAR(1e3 * last[1].toDouble(), drawn.y.back(), 1e-9);
}

} // namespace
} // namespace halbench::app
