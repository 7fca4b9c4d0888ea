// The questions of saving and opening: a name, a conflict with somebody's newer version, changes that are not saved.
import { useState, type ReactNode } from "react";
import { Button, Dialog, Heading, Modal, ModalOverlay } from "react-aria-components";
import { TextBox } from "../dialog/TextBox";
import { useCell } from "../state/cell";
import { useDrawing } from "../state/drawing";
import { openStored, save, saveAs, settle, useKeep, type Pending as Question } from "../state/keep";
import { openWindow } from "../state/windows";
import { t } from "../words/words";

export function Pending() {
  const pending = useKeep((state) => state.pending);
  return (
    <ModalOverlay className="modal-back" isOpen={pending !== undefined} isDismissable onOpenChange={(open) => !open && settle()}>
      <Modal className="modal"><Dialog>{pending && <Body question={pending} />}</Dialog></Modal>
    </ModalOverlay>
  );
}

function Frame({ title, children, acts }: { title: string; children: ReactNode; acts: ReactNode }) {
  return <><div className="body"><Heading slot="title">{title}</Heading>{children}</div><div className="acts">{acts}</div></>;
}

function Body({ question }: { question: Question }) {
  if (question.kind === "name") return <NameIt suggested={question.suggested} />;
  if (question.kind === "exists")
    return (
      <Frame title={t("keep.existsTitle", { name: question.name })} acts={<><Button className="button" onPress={settle}>{t("keep.cancel")}</Button><Button className="button primary" onPress={() => useKeep.setState({ pending: { kind: "name", suggested: question.name } })}>{t("keep.otherName")}</Button></>}>
        <p>{t("keep.existsText")}</p>
      </Frame>
    );
  if (question.kind === "discard")
    return (
      <Frame title={t("keep.discardTitle")} acts={
        <>
          <Button className="button" onPress={settle}>{t("keep.cancel")}</Button>
          <Button className="button danger" onPress={() => (settle(), question.then())}>{t("keep.discard")}</Button>
          <Button className="button primary" onPress={() => (settle(), void save())}>{t("keep.saveFirst")}</Button>
        </>
      }><p>{t("keep.discardText")}</p></Frame>
    );
  return (
    <Frame title={t("keep.conflictTitle", { name: question.name })} acts={
      <>
        <Button className="button" onPress={() => (settle(), void openStored(question.name))}>{t("keep.takeTheirs")}</Button>
        <Button className="button" onPress={() => useKeep.setState({ pending: { kind: "name", suggested: question.name } })}>{t("keep.otherName")}</Button>
        <Button className="button danger" onPress={() => void saveAs(question.name, question.newest)}>{t("keep.replace")}</Button>
      </>
    }>
      <p>{t("keep.conflictText", { version: question.newest })}</p>
      <Button className="button quiet small" onPress={() => (settle(), openWindow("versions", question.name))}>{t("keep.seeDifference")}</Button>
    </Frame>
  );
}

function NameIt({ suggested }: { suggested: string }) {
  const [name, setName] = useState(suggested);
  const stored = useCell((state) => state.stored ?? []);
  const own = useDrawing((state) => state.name);
  const wrong = name !== "" && !/^[\p{L}\p{N}][\p{L}\p{N} ._-]*$/u.test(name);
  const there = stored.find((each) => each.name === name && each.name !== own);
  const put = () => name !== "" && !wrong && void saveAs(name, name === own ? useDrawing.getState().version : 0);
  return (
    <form onSubmit={(event) => (event.preventDefault(), put())}>
      <Frame title={t("keep.nameTitle")} acts={<><Button className="button" onPress={settle}>{t("keep.cancel")}</Button><Button className="button primary" type="submit" isDisabled={name === "" || wrong || there !== undefined}>{t("keep.save")}</Button></>}>
        <TextBox label={t("keep.name")} value={name} onChange={setName} hint={wrong ? t("keep.wrongName") : there ? t("keep.taken") : t("keep.nameHint")} />
      </Frame>
    </form>
  );
}
