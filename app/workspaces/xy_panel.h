#pragma once

#include "app/procedures/ellipse_shape.h"
#include "app/workspaces/file_chooser.h"
#include "app/workspaces/file_queue.h"
#include "app/workspaces/latest_task.h"
#include "app/workspaces/signal_stretch.h"
#include "app/workspaces/workbench.h"
#include "widgets/figure.h"

#include <QTimer>
#include <QWidget>

class QCheckBox;
class QLabel;
class QStackedWidget;

namespace halbench::widgets {
class EstimateTable;
class FigureView;
class QuantityEdit;
} // namespace halbench::widgets

namespace halbench::app {

class SignalBox;

/// Two signals against each other over the last seconds, at first the Hall sensors with the ellipse that fits
/// them (resources/help/monitor.md, "XY").
class XyPanel : public QWidget {
    Q_OBJECT

public:
    explicit XyPanel(Workbench& bench, QWidget* parent = nullptr);

    void setFileChooser(FileChooser chooser) { m_chooser = std::move(chooser); }

Q_SIGNALS:
    void connectRequested(); ///< of the simulated motor, while there is nothing to show

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    struct Answer {
        SignalPair points; ///< as many as are drawn, as shown
        std::optional<Result<control::HallEllipseFit>> fit;
    };
    QWidget* buildContent();
    QWidget* buildFields(QWidget* parent);
    void onDevice();
    void want();
    void ask();
    void askAnew();
    void showAnswer(const Answer& answer);
    void showFit(const Result<control::HallEllipseFit>& fit, widgets::Figure& figure);
    void sayWarning(const Error& error);
    DisplayQuantity shown(const SignalBox& box) const;

    Workbench& m_bench;
    FileChooser m_chooser;
    QStackedWidget* m_pages = nullptr;
    SignalBox* m_x = nullptr;
    SignalBox* m_y = nullptr;
    widgets::QuantityEdit* m_stretch = nullptr;
    QCheckBox* m_ellipse = nullptr;
    widgets::FigureView* m_view = nullptr;
    widgets::EstimateTable* m_numbers = nullptr;
    QLabel* m_words = nullptr;
    QTimer m_timer;
    std::optional<std::uint64_t> m_seen; ///< revision of the history
    FileQueue m_files;
    LatestTask m_task; ///< last: what it computes ends first
};

} // namespace halbench::app
