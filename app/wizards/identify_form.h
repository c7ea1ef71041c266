#pragma once

#include "app/procedures/identify/identify_procedure.h"

#include <QStringList>
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

/// Settings of an identification.
class IdentifyForm : public QWidget {
    Q_OBJECT
public:
    explicit IdentifyForm(QWidget* parent = nullptr);

    /// What the fields show, also what is still being typed. Errors: of sweepCurrents_A; InvalidInput with
    /// all of problems().
    Result<IdentifyConfig> config() const;
    /// What is wrong and what to do about it, a sentence for each field.
    QStringList problems() const;
    /// What was entered last and could not be used, and what the fields show instead; empty once something
    /// else is entered.
    const QString& notice() const { return m_notice; }
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
    void buildAdvanced();
    void refreshWords();
    void watchCurrent(widgets::QuantityEdit& box);
    void onChange();
    CurrentSweep sweep() const;
    bool isSweepBackwards() const;
    void markSweep();

    double m_limit_A = 4.0;
    QFormLayout* m_form = nullptr;
    std::array<widgets::QuantityEdit*, 3> m_currents{}; ///< from, to, step
    QString m_notice;
    bool m_isReverting = false; ///< while the click that left the field is on its way
    QComboBox* m_directions = nullptr;
    std::array<widgets::OptionalNumberEdit*, 4> m_given{}; ///< as GivenSymbols
    QToolButton* m_advanced = nullptr;
    widgets::OptionalNumberEdit* m_currentTolerance = nullptr;
    QSpinBox* m_seed = nullptr;
    std::vector<QLabel*> m_labels; ///< of the rows, in their order
};

} // namespace halbench::app
