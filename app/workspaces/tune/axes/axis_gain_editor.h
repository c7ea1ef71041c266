#pragma once

#include "app/procedures/tune/tune.h"

#include <QWidget>

#include <array>

class QLabel;

namespace halbench::widgets {
class OptionalNumberEdit;
}

namespace halbench::app {

/// Gains, set-point weights and derivative filter of one axis in its units. Filters in series are kept as
/// they are.
class AxisGainEditor : public QWidget {
    Q_OBJECT
public:
    explicit AxisGainEditor(QWidget* parent = nullptr);

    void setLaw(const LoopLaw& law, const LoopAxis& axis);
    /// Errors: InvalidInput naming the field.
    Result<LoopLaw> law() const;

Q_SIGNALS:
    void edited(); ///< by the user

protected:
    void changeEvent(QEvent* event) override;

private:
    enum Field { Proportional, Integral, Derivative, ReferenceWeight, DerivativeWeight, Filter, Fields };
    void refreshWords();

    LoopLaw m_law;
    LoopAxis m_axis;
    struct Row {
        QLabel* name;
        widgets::OptionalNumberEdit* edit;
        QLabel* unit;
    };
    std::array<Row, Fields> m_rows{};
};

} // namespace halbench::app
