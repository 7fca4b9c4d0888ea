// The window of a channel: a chart over time, or the profile of a scan.
import { t } from "../words/words";
import { ChannelChart } from "./Chart";
import { useChannels } from "./live";
import { ProfileView } from "./Profile";

export default function ChannelWindow({ about }: { about: string }) {
  const channels = useChannels((state) => state.channels);
  const channel = channels?.find((each) => each.channel === about);
  if (!channels) return <p className="nothing loading">{t("loading")}</p>;
  if (!channel) return <p className="nothing">{t("chart.absent", { name: about })}</p>;
  return channel.form === "profile" ? <ProfileView channel={channel} /> : <ChannelChart channel={channel} />;
}
