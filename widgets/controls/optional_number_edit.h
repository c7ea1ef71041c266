#pragma once

#include <QLineEdit>

#include <optional>

namespace halbench::widgets {

/// What a number may be.
struct NumberLimits {
    double min = 0.0;
    double max = 1e9;
    bool isMinAllowed = true; ///< false: more than min
};

/// A number or nothing: empty means "not given". What is not a number within its limits turns red and says
/// why; it has no value then. Numbers are read in the user's notation or the C one.
class OptionalNumberEdit : public QLineEdit {
    Q_OBJECT
public:
    explicit OptionalNumberEdit(QWidget* parent = nullptr);

    void setLimits(const NumberLimits& limits);
    void setValue(std::optional<double> value);
    /// Nothing when empty or invalid.
    std::optional<double> value() const { return m_value; }
    bool isValid() const { return m_problem.isEmpty(); }
    const QString& problem() const { return m_problem; }

    /// What it is for; stands in the tooltip while nothing is wrong.
    void setExplanation(const QString& text);

Q_SIGNALS:
    void valueChanged(); ///< the user edited it; also when it became invalid

protected:
    void changeEvent(QEvent* event) override;

private:
    void read();
    void refreshWords();

    NumberLimits m_limits;
    std::optional<double> m_value;
    std::optional<double> m_exact; ///< as it was set, with every digit
    QString m_exactText;           ///< what it showed of that
    QString m_problem;
    QString m_explanation;
};

} // namespace halbench::widgets
