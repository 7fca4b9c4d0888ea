// A choice out of a list.
import { Button, Label, ListBox, ListBoxItem, Popover, Select, SelectValue } from "react-aria-components";
import { Symbol } from "../symbols/Symbol";
import { t } from "../words/words";

export interface ChooseOption {
  id: string;
  name: string;
  aside?: string;
}

interface Props {
  label: string;
  value: string;
  onChange(value: string): void;
  options: readonly ChooseOption[];
  hint?: string;
  hideLabel?: boolean;
}

export function Choose({ label, value, onChange, options, hint, hideLabel = false }: Props) {
  const known = options.some((each) => each.id === value) || value === "" ? options : [{ id: value, name: value, aside: t("choose.missing") }, ...options];
  return (
    <Select className="field" aria-label={hideLabel ? label : undefined} selectedKey={value === "" ? null : value} placeholder={t("choose.placeholder")}
      onSelectionChange={(key) => key !== null && onChange(String(key))}>
      {!hideLabel && <Label>{label}</Label>}
      <Button className="select-button"><SelectValue /><Symbol name="down" size={16} /></Button>
      {hint && <span className="hint">{hint}</span>}
      <Popover className="popover">
        <ListBox className="listbox" items={known}>
          {(each) => (
            <ListBoxItem id={each.id} textValue={each.name} className="option">
              <span className="name">{each.name}</span>
              {each.aside && <span className="aside" slot="description">{each.aside}</span>}
            </ListBoxItem>
          )}
        </ListBox>
      </Popover>
    </Select>
  );
}
