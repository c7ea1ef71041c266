#pragma once

#include "app/procedures/calibrate/ellipse_shape.h"
#include "app/workbench/signals/signal_stretch.h"
#include "app/workspaces/parts/live_picture.h"
#include "widgets/figure/figure.h"

#include <memory>
#include <string>

class QCheckBox;
class QLabel;

namespace halbench::widgets {
class EstimateTable;
class QuantityEdit;
} // namespace halbench::widgets

namespace halbench::app {

/// Two signals against each other over the last seconds, at first the Hall sensors with the ellipse that fits
/// them (resources/help/monitor.md, "XY").
class XyPanel : public LivePicture {
    Q_OBJECT

public:
    explicit XyPanel(Workbench& bench, QWidget* parent = nullptr);

protected:
    void takeCatalogue(const devices::Catalogue& catalogue) override;
    void compute() override;
    Table table() const override;

private:
    struct Answer {
        SignalPair points;                     ///< as many as are drawn, as shown
        std::shared_ptr<const SignalPair> all; ///< in SI, of these columns
        std::string xColumn;
        std::string yColumn;
        std::optional<Result<control::HallEllipseFit>> fit;
    };
    QWidget* buildContent();
    QWidget* buildFields(QWidget* parent);
    void showAnswer(const Answer& answer);
    void showFit(const Result<control::HallEllipseFit>& fit, widgets::Figure& figure);

    SignalBox* m_x = nullptr;
    SignalBox* m_y = nullptr;
    widgets::QuantityEdit* m_stretch = nullptr;
    QCheckBox* m_ellipse = nullptr;
    widgets::FigureView* m_view = nullptr;
    widgets::EstimateTable* m_numbers = nullptr;
    QLabel* m_words = nullptr;
    Answer m_shown;
};

} // namespace halbench::app
