#pragma once

#include "app/procedures/identify_procedure.h"

#include <QWidget>

#include <array>
#include <map>
#include <string>

class QComboBox;
class QFormLayout;
class QGroupBox;
class QLabel;
class QSpinBox;
class QToolButton;

namespace halbench::widgets {
class OptionalNumberEdit;
class QuantityEdit;
} // namespace halbench::widgets

namespace halbench::app {

/// What the user may set of an identification.
class IdentifyForm : public QWidget {
    Q_OBJECT
public:
    explicit IdentifyForm(QWidget* parent = nullptr);

    /// Errors: of sweepCurrents_A; InvalidInput for a current or a given constant that is no possible number.
    Result<IdentifyConfig> config() const;
    /// The given constants that are numbers, by symbol; SI.
    std::map<std::string, double> given() const;
    void setGiven(const std::map<std::string, double>& given);
    void setCurrentLimit_A(double limit_A);
    void setSeed(std::uint64_t seed);
    /// Puts the cursor where the constant can be given: "J", "c", "Kf", "phi".
    void focusConstant(const QString& symbol);

Q_SIGNALS:
    void changed();

protected:
    void changeEvent(QEvent* event) override;

private:
    void buildSweep();
    void buildGiven();
    void refreshWords();

    double m_limit_A = 4.0;
    QFormLayout* m_form = nullptr;
    std::array<widgets::QuantityEdit*, 3> m_currents{}; ///< from, to, step
    std::array<QString, 3> m_refused; ///< why what was entered there last is no current; empty: it is one
    QComboBox* m_directions = nullptr;
    std::array<widgets::OptionalNumberEdit*, 4> m_given{}; ///< as GivenSymbols
    QToolButton* m_advanced = nullptr;
    QSpinBox* m_seed = nullptr;
    std::vector<QLabel*> m_labels; ///< of the rows, in their order
};

} // namespace halbench::app
