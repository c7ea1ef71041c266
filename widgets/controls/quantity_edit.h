#pragma once

#include <QDoubleSpinBox>
#include <QString>

namespace halbench::widgets {

/// What a quantity may be and how it is written; values are those that are shown.
struct QuantityFormat {
    QString unit; ///< as shown
    double min = 0.0;
    double max = 1.0;
    double step = 0.1;
    int decimals = 3;
};

/// A number with its unit. It is always finite and inside its limits; it can be typed in the user's notation
/// or the programmers', with or without the unit; Page Up and Page Down make ten steps. A text that is no
/// such number stays to be seen, turns red and says why in place; it has no value. The word for the least
/// value (specialValueText) may stand instead of it.
class QuantityEdit : public QDoubleSpinBox {
    Q_OBJECT
public:
    explicit QuantityEdit(QWidget* parent = nullptr);

    void setFormat(const QuantityFormat& format);
    const QuantityFormat& format() const { return m_format; }
    /// From the program: does not send `edited`. Not finite is our own mistake.
    void setQuantity(double value);

    /// The limits in words.
    QString rangeText() const;
    QString allowedText() const; ///< the same as a sentence
    /// Why this text cannot be used here, and what can; empty when it can.
    QString problemOf(const QString& text) const;
    /// What is said of the text in place now: it shows red.
    const QString& problem() const { return m_problem; }

    QValidator::State validate(QString& text, int& position) const override;
    void fixup(QString& text) const override;
    double valueFromText(const QString& text) const override;
    QString textFromValue(double value) const override;
    void stepBy(int steps) override;

Q_SIGNALS:
    void edited(double value); ///< by the user
    void entered();            ///< Enter, with a number that may be
    /// Enter, or leaving the field, with this text that is no number inside the limits. While the focus stays
    /// the text does too; afterwards the field shows the number before.
    void refused(const QString& text);

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void describe();
    QString typedOf(const QString& text) const;
    bool isWordForLeast(const QString& text) const;
    bool isTooFar(const QString& typed) const;
    void judgeTyped(const QString& text);
    void showProblem(const QString& problem);

    QuantityFormat m_format;
    QString m_problem;
};

} // namespace halbench::widgets
