// From the hand's move to the painted window: the whole Tune panel of a window, driven by mouse events, with
// the worker, everything that is drawn beside the proposed loop, and a thousand motors of uncertainty.
#include "app/documents/model_file.h"
#include "app/documents/result_documents.h"
#include "app/documents/text/json_value.h"
#include "app/workbench/shared_results.h"
#include "app/workspaces/tune/loop/loop_view.h"
#include "app/workspaces/tune/tune_panel.h"
#include "app/workspaces/tune/tune_question.h"
#include "tests/app/workspaces/published_motor.h"
#include "tests/bench/goal.h"
#include "widgets/figure/figure_view.h"
#include "widgets/figure/offscreen_application.h"

#include <QApplication>
#include <QMouseEvent>
#include <QtTest/QTest>

#include <algorithm>
#include <chrono>
#include <functional>
#include <utility>
#include <vector>

namespace halbench::bench {
namespace {

using namespace halbench::app;
using Clock = std::chrono::steady_clock;

constexpr int Patience_ms = 60000;

/// Sees a picture being painted while a condition holds.
class PaintWatch : public QObject {
public:
    PaintWatch(QWidget& watched, std::function<bool()> isNew) : m_isNew(std::move(isNew)) {
        watched.installEventFilter(this);
    }
    bool isPainted = false;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        isPainted = isPainted || (event->type() == QEvent::Paint && m_isNew());
        return QObject::eventFilter(watched, event);
    }

private:
    std::function<bool()> m_isNew;
};

/// The panel as a window has it, with the published motor identified.
struct TuneRig {
    Workbench bench;
    TunePanel panel{bench};

    bool prepare(bool hasDevice) {
        panel.resize(1440, 820);
        panel.show();
        if (!QTest::qWaitForWindowExposed(&panel)) {
            return false;
        }
        if (hasDevice) {
            bench.session().connectDevice(QStringLiteral("sim:htm?seed=4"), {0.0});
            if (!QTest::qWaitFor([this] { return !bench.deviceValues().empty(); }, Patience_ms)) {
                return false;
            }
        }
        bench.setIdentification(publishedMotor());
        return QTest::qWaitFor([this] { return bench.design().has_value(); }, Patience_ms);
    }

    /// Three designs of the project, drawn beside the proposed one.
    bool keepDesigns() {
        std::vector<KeptDesign> designs;
        for (const char* method : {"lqr", "simc", "lead"}) {
            TuneQuestion question;
            question.motor = motorEstimate(*bench.identification());
            question.config.method = method;
            const auto answer = answerTuning(question);
            const auto text = answer ? toJsonText(gainsDocument(bench.designHeader(), *answer))
                                     : Result<std::string>(failure(answer.error()));
            if (!text) {
                return false;
            }
            designs.push_back(keptDesign(method, *text));
        }
        panel.setSavedDesigns(std::move(designs));
        const auto isDrawn = [this] { return curves() >= 4; };
        return QTest::qWaitFor(isDrawn, Patience_ms);
    }

    widgets::FigureView& picture() { return panel.findChild<LoopView*>()->picture(); }
    std::size_t curves() { return picture().figure().panels.at(0).curves.size(); }
    std::vector<double> drawn() { return picture().figure().panels.at(0).curves.at(0).y; }
};

void send(widgets::FigureView& picture, QEvent::Type type, const QPoint& at, Qt::MouseButton button,
          Qt::MouseButtons buttons) {
    QMouseEvent event(type, QPointF(at), button, buttons, Qt::NoModifier);
    QApplication::sendEvent(&picture, &event);
}

/// Milliseconds from a move of the held crossover until a picture of other gains is painted, the median of
/// many; each move waits for the one before.
double moveToPixel_ms(TuneRig& rig) {
    widgets::FigureView& picture = rig.picture();
    std::vector<double> before;
    PaintWatch watch(picture, [&] { return rig.drawn() != before; });
    QPoint at = picture.handlePlace(0).value();
    send(picture, QEvent::MouseButtonPress, at, Qt::LeftButton, Qt::LeftButton);
    std::vector<double> times_ms;
    for (int move = 0; move < 60; ++move) {
        before = rig.drawn();
        watch.isPainted = false;
        at += QPoint(move / 10 % 2 == 0 ? -3 : 3, 0);
        const auto start = Clock::now();
        send(picture, QEvent::MouseMove, at, Qt::NoButton, Qt::LeftButton);
        // The window paints all its pictures in one round of events: it is over when that round is.
        while (!watch.isPainted && Clock::now() - start < std::chrono::seconds(1)) {
            QApplication::processEvents(QEventLoop::WaitForMoreEvents);
        }
        times_ms.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
    }
    send(picture, QEvent::MouseButtonRelease, at, Qt::LeftButton, Qt::NoButton);
    std::nth_element(times_ms.begin(), times_ms.begin() + 30, times_ms.end());
    return times_ms[30];
}

void benchMoveToPixel(Goals& goals, bool isCompared) {
    const char* name = isCompared
                           ? "hand's move to painted picture, three kept designs and the device's gains"
                           : "hand's move to painted picture, the proposed loop alone";
    TuneRig rig;
    if (!rig.prepare(isCompared) || (isCompared && !rig.keepDesigns())) {
        goals.failed(name, "the panel does not come up");
        return;
    }
    // Median on the wall clock, with the worker's thread, the layout and the painting of the whole window.
    goals.below(name, moveToPixel_ms(rig), 16.0, "ms");
}

} // namespace
} // namespace halbench::bench

int main() {
    const auto application = halbench::widgets::OffscreenApplication::ensure();
    if (!application) {
        return 1;
    }
    halbench::bench::Goals goals;
    halbench::bench::benchMoveToPixel(goals, false);
    halbench::bench::benchMoveToPixel(goals, true);
    return goals.exitCode();
}
