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
/// or the programmers', with or without the unit; Page Up and Page Down make ten steps.
class QuantityEdit : public QDoubleSpinBox {
    Q_OBJECT
public:
    explicit QuantityEdit(QWidget* parent = nullptr);

    void setFormat(const QuantityFormat& format);
    const QuantityFormat& format() const { return m_format; }
    /// From the program: does not send `edited`. Not finite is our own mistake.
    void setQuantity(double value);

    QValidator::State validate(QString& text, int& position) const override;
    double valueFromText(const QString& text) const override;
    QString textFromValue(double value) const override;

Q_SIGNALS:
    void edited(double value); ///< by the user

protected:
    void changeEvent(QEvent* event) override;

private:
    void describe();

    QuantityFormat m_format;
};

} // namespace halbench::widgets
