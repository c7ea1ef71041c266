#include "app/window/docks/dock_layout.h"
#include "tests/app/window/clipped_buttons.h"
#include "tests/app/window/window_test.h"
#include "widgets/controls/stop_button.h"

namespace halbench::app {
namespace {

/// The text of the running window grows and shrinks, as when the desktop's scale or font is changed.
class ScaleChangeTest : public WindowTest {
protected:
    void dress(double scale_ratio) {
        const auto theme = widgets::loadTheme("light");
        ASSERT_TRUE(theme);
        widgets::applyTheme(application, *theme, {QLocale(), widgets::Dress().fontSize_pt * scale_ratio});
        QTest::qWait(100); // layouts follow with the next frames
    }

    /// Panels in sight that have less room than they say they need.
    QStringList cutPanels() const {
        QStringList found;
        for (const PanelSpec& spec : panelSpecs()) {
            const QWidget* panel = window->docks().panel(spec.id);
            const QSize need = panel->minimumSizeHint();
            if (panel->isVisible() && !panel->visibleRegion().isEmpty() &&
                (panel->width() < need.width() || panel->height() < need.height())) {
                found << spec.id;
            }
        }
        return found;
    }
};

TEST_F(ScaleChangeTest, nothingIsClippedWhenTheTextGrowsAndShrinksAtRunTime) {
    open();
    window->resize(1920, 1080);
    connectMotor(1.0);
    auto* stop = window->findChild<widgets::StopButton*>();
    for (const double scale_ratio : {1.25, 1.0}) {
        dress(scale_ratio);
        for (const Perspective perspective : AllPerspectives) {
            SCOPED_TRACE(perspectiveId(perspective).toStdString() + " at " + std::to_string(scale_ratio));
            window->docks().setPerspective(perspective);
            QTest::qWait(100);
            EXPECT_TRUE(window->rect().contains(QRect(stop->mapTo(window.get(), QPoint()), stop->size())));
            EXPECT_EQ(clippedButtons(*window).join(", ").toStdString(), "");
            EXPECT_LE(window->width(), 1920);
        }
    }
    EXPECT_EQ(session().state(), SessionState::Connected);
}

/// Kept on a display of small text, opened on one of large text.
TEST_F(ScaleChangeTest, anArrangementThatWasKeptAtAnotherScaleCutsNothing) {
    QHash<QString, QByteArray> kept;
    open();
    dress(0.8);
    window->resize(1280, 720);
    for (const Perspective perspective : AllPerspectives) {
        window->docks().setPerspective(perspective);
        QTest::qWait(50);
    }
    kept = window->docks().arrangements();
    window->resize(1920, 1200);
    dress(1.25);
    window->docks().setArrangements(kept);
    for (const Perspective perspective : AllPerspectives) {
        window->docks().setPerspective(perspective);
        QTest::qWait(100);
        EXPECT_EQ(clippedButtons(*window).join(", ").toStdString(), "")
            << perspectiveId(perspective).toStdString();
        EXPECT_EQ(cutPanels().join(", ").toStdString(), "") << perspectiveId(perspective).toStdString();
    }
}

} // namespace
} // namespace halbench::app
