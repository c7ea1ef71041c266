#pragma once

#include "app/procedures/frequency/frequency_procedure.h"

#include <QWidget>

#include <array>

class QComboBox;
class QFormLayout;
class QLabel;

namespace halbench::widgets {
class OptionalNumberEdit;
class QuantityEdit;
} // namespace halbench::widgets

namespace halbench::app {

/// What the user may set of a frequency response.
class FrequencyForm : public QWidget {
    Q_OBJECT
public:
    explicit FrequencyForm(QWidget* parent = nullptr);

    /// Error: InvalidInput for a field that shows no possible number. What the numbers mean together is
    /// judged by planFrequency().
    Result<FrequencyConfig> config() const;

Q_SIGNALS:
    void changed();

protected:
    void changeEvent(QEvent* event) override;

private:
    enum Field { From, To, Base, Periods, Coherence, Fields };

    void addRow(QWidget* field, const QString& unit);
    void buildNumbers();
    void refreshWords();

    QFormLayout* m_form = nullptr;
    QComboBox* m_excitation = nullptr;
    std::array<widgets::QuantityEdit*, Fields> m_numbers{};
    std::array<QString, Fields> m_refused; ///< why what was entered there last is no number for it
    widgets::OptionalNumberEdit* m_amplitude_deg = nullptr;
    std::vector<QLabel*> m_labels; ///< of the rows, in their order
};

} // namespace halbench::app
