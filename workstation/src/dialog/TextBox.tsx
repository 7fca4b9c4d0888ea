// A field for a text; changes reach the drawing while they are typed.
import { Input, Label, TextArea, TextField } from "react-aria-components";

interface Props {
  label: string;
  value: string;
  onChange(value: string): void;
  onBlur?(): void;
  long?: boolean;
  hint?: string;
  placeholder?: string;
}

export function TextBox({ label, value, onChange, onBlur, long = false, hint, placeholder }: Props) {
  return (
    <TextField className="field" value={value} onChange={onChange} {...(onBlur ? { onBlur } : {})}>
      <Label>{label}</Label>
      {long ? <TextArea rows={2} placeholder={placeholder} /> : <Input className="input" placeholder={placeholder} autoComplete="off" spellCheck={false} />}
      {hint && <span className="hint">{hint}</span>}
    </TextField>
  );
}
