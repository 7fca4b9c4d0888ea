#!/usr/bin/env python3
"""Runs one study on each engine, on three virtual hosts: study_hosts.py PAL FOLDER [--proofs N | --study FILE].

A host is a set of namespaces (network, mounts, host name, processes) with addresses of its own; veth pairs connect each two.
On each run munge, slurmd and sshd, on the first one slurmctld, too. The study is run on one core, on two cores, by GNU parallel over
ssh, and by Slurm; then by the last two again while one host is killed in the middle. All tables must be the same bytes. Needs root.
With --study a study of one's own takes the place of the program's, and no host is killed.
Whatever happens, the hosts are gone at the end: with the first process of its namespace the kernel ends all others.
"""
import argparse
import ctypes
import itertools
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time

HOSTS = ["pal1", "pal2", "pal3"]
PROGRAMS = ["unshare", "nsenter", "ip", "munged", "slurmctld", "slurmd", "sbatch", "sshd", "ssh-keygen", "parallel"]
# Some hundred proofs of a tenth of a second and more.
STUDY = """title = "A study on several hosts"
files = ["{source}/skills_pal/press/press.pal"]
environments = ["{source}/skills_pal/workcell_one_processor.pal"]
environment-names = ["one-processor"]
[[figure]]
name = "extract-z OF LS1"
set = ["extract-z OF LS1 = 100 us..{{}}"]
from = "100 us"
to = "{last} us"
step = "10 us"
[[figure]]
name = "SM1.priority"
values = [1, 2]
"""


def die_with_parent():
    """The kernel ends the host if this program ends in any way, killed or not (prctl(2), PR_SET_PDEATHSIG)."""
    ctypes.CDLL(None).prctl(1, signal.SIGKILL)


class Host:
    """Its processes are children of `init`, in namespaces that end with it."""

    def __init__(self, name, folder):
        self.name = name
        self.folder = folder / name
        self.folder.mkdir(parents=True)
        (self.folder / "root-ssh").mkdir(mode=0o700)
        script = (f"hostname {name} && mount --bind {folder}/hosts /etc/hosts && mount -t tmpfs none /run && mkdir -p /run/sshd /run/munge && "
                  f"mkdir -p /root/.ssh && mount --bind {self.folder}/root-ssh /root/.ssh && ip link set lo up && "
                  f"touch {self.folder}/up && exec sleep infinity")
        self.init = subprocess.Popen(["unshare", "--net", "--mount", "--uts", "--pid", "--fork", "--mount-proc", "--kill-child",
                                      "sh", "-c", script], preexec_fn=die_with_parent)
        wait_for(lambda: (self.folder / "up").exists(), f"host {name}")
        # The first process of the namespace is the child of unshare.
        self.pid = int(subprocess.run(["ps", "-o", "pid=", "--ppid", str(self.init.pid)], capture_output=True, text=True, check=True).stdout.split()[0])

    def words(self, command):
        return ["nsenter", "--target", str(self.pid), "--net", "--mount", "--uts", "--pid", f"--wdns={self.folder}", *command]

    def run(self, *command, **options):
        return subprocess.run(self.words(command), check=True, **options)

    def kill(self):
        self.init.kill()
        self.init.wait()


def wait_for(condition, what, seconds=30):
    end = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > end:
            raise RuntimeError(f"{what} did not come up in {seconds} s")
        time.sleep(0.1)


def connect(hosts):
    """A veth pair between each two hosts, each a network of two addresses."""
    addresses = {host.name: {} for host in hosts}
    for number, (a, b) in enumerate(itertools.combinations(hosts, 2)):
        names = [f"to-{b.name}", f"to-{a.name}"]
        subprocess.run(["ip", "link", "add", "name", names[0], "netns", str(a.pid), "type", "veth", "peer", "name", names[1], "netns", str(b.pid)],
                       check=True)
        for host, other, name, last in [(a, b, names[0], 1), (b, a, names[1], 2)]:
            addresses[host.name][other.name] = f"10.77.{number}.{last}"
            host.run("ip", "address", "add", f"10.77.{number}.{last}/30", "dev", name)
            host.run("ip", "link", "set", name, "up")
    return addresses


def own_address(host):
    """On its loopback: that of a link would go with the host at the other end."""
    return f"10.78.0.{HOSTS.index(host.name) + 1}"


def names_seen_by(host, addresses):
    """Its /etc/hosts: each other host has an address on the network that it shares with this one; its own stays if those go."""
    lines = ["127.0.0.1 localhost"]
    for other in HOSTS:
        address = own_address(host) if other == host.name else addresses[other][host.name]
        lines.append(f"{address} {other}")
    return "\n".join(lines) + "\n"


def slurm_configuration(folder):
    nodes = "\n".join(f"NodeName={name} NodeAddr={name} CPUs=2 RealMemory=1000" for name in HOSTS)
    (folder / "cgroup.conf").write_text("CgroupPlugin=cgroup/v1\n")  # without it slurmd ends where there are no cgroups
    (folder / "slurm.conf").write_text(f"""ClusterName=pal
SlurmctldHost={HOSTS[0]}
AuthType=auth/munge
SlurmUser=root
SlurmdUser=root
StateSaveLocation=/run/slurm-state
SlurmdSpoolDir=/run/slurm-spool
SlurmctldPidFile=/run/slurmctld.pid
SlurmdPidFile=/run/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SwitchType=switch/none
MpiDefault=none
ReturnToService=2
SlurmdTimeout=15
SchedulerParameters=batch_sched_delay=0,sched_interval=1,bf_interval=1,bf_continue
{nodes}
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
""")


class Cluster:
    def __init__(self, folder):
        self.folder = folder
        self.hosts = []

    def start(self):
        (self.folder / "hosts").write_text("127.0.0.1 localhost\n")
        self.hosts = [Host(name, self.folder) for name in HOSTS]
        addresses = connect(self.hosts)
        slurm_configuration(self.folder)
        key = self.folder / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o400)
        subprocess.run(["ssh-keygen", "-q", "-t", "ed25519", "-N", "", "-f", str(self.folder / "id")], check=True)
        for host in self.hosts:
            self.start_host(host, addresses)
        self.hosts[0].run("mkdir", "-p", "/run/slurm-state")
        self.daemon(self.hosts[0], "slurmctld", "-c", "-f", self.folder / "slurm.conf")
        for host in self.hosts:
            self.daemon(host, "slurmd", "-f", self.folder / "slurm.conf")
        wait_for(lambda: self.idle() == len(HOSTS), "Slurm", 60)

    def start_host(self, host, addresses):
        (host.folder / "hosts").write_text(names_seen_by(host, addresses))
        host.run("mount", "--bind", str(host.folder / "hosts"), "/etc/hosts")
        host.run("ip", "address", "add", f"{own_address(host)}/32", "dev", "lo")
        host.run("mkdir", "-p", "/run/slurm-spool")
        self.daemon(host, "munged", "--force", f"--key-file={self.folder}/munge.key", "--socket=/run/munge/munge.socket.2",
                    "--pid-file=/run/munge/munged.pid", f"--log-file={host.folder}/munged.log", "--seed-file=/run/munge/seed")
        secret = host.folder / "root-ssh"
        shutil.copy(self.folder / "id", secret / "id_ed25519")
        (secret / "id_ed25519").chmod(0o600)
        shutil.copy(self.folder / "id.pub", secret / "authorized_keys")
        (secret / "config").write_text("StrictHostKeyChecking accept-new\n")
        shutil.copy(self.folder / "id", host.folder / "host-key")
        (host.folder / "host-key").chmod(0o600)
        (host.folder / "sshd_config").write_text(
            f"HostKey {host.folder}/host-key\nPidFile /run/sshd.pid\nUsePAM no\nPermitRootLogin prohibit-password\nPasswordAuthentication no\n"
            f"MaxStartups 100\nMaxSessions 100\n")
        self.daemon(host, shutil.which("sshd"), "-f", host.folder / "sshd_config", "-E", host.folder / "sshd.log")

    def daemon(self, host, *command):
        host.run(*map(str, command), stdout=subprocess.DEVNULL, env=self.environment())

    def environment(self):
        return {**os.environ, "SLURM_CONF": str(self.folder / "slurm.conf")}

    def idle(self):
        done = subprocess.run(self.hosts[0].words(["sinfo", "--noheader", "--Node", "--states=idle", "--format=%N"]), capture_output=True,
                              text=True, check=False, env=self.environment(), timeout=20)
        return len(done.stdout.split())

    def stop(self):
        for host in self.hosts:
            host.kill()


def made(study):
    return len(list((study / "proofs").glob("*/*.proof")))


def sweep(cluster, pal, study, name, arguments, kill=None):
    """The table of the study, made from nothing on the first host. `kill`: a host that goes when a third is made."""
    results = cluster.folder / name
    begin = time.monotonic()
    running = subprocess.Popen(cluster.hosts[0].words([pal, "sweep", str(study), "-o", str(results), *arguments]), env=cluster.environment())
    try:
        if kill is not None:
            wait_for(lambda: made(results) >= kill[1] or running.poll() is not None, "a third of the proofs", 300)
            if running.poll() is not None:
                raise RuntimeError(f"{name}: the study ended before a host could be killed")
            print(f"{name}: {kill[0].name} is killed after {made(results)} proofs", flush=True)
            kill[0].kill()
        status = running.wait(timeout=600)
    finally:
        if running.poll() is None:
            running.kill()
            running.wait()
    if status != 0:
        raise RuntimeError(f"{name}: pal sweep ended with {status}")
    print(f"{name}: {made(results)} proofs in {time.monotonic() - begin:.1f} s", flush=True)
    return {file.name: file.read_bytes() for file in results.iterdir() if file.is_file()}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("pal")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--proofs", type=int, default=120, help="of the program's own study")
    parser.add_argument("--study", type=pathlib.Path, help="another study")
    options = parser.parse_args()
    missing = [program for program in PROGRAMS if shutil.which(program) is None]
    if os.geteuid() != 0 or missing:
        sys.exit(f"study_hosts needs root, and the programs {', '.join(missing) or 'it has'} "
                 "(Debian: apt-get install munge slurmctld slurmd slurm-client openssh-server parallel iproute2)")
    folder = options.folder.resolve()
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    source = pathlib.Path(__file__).resolve().parents[2]
    study = options.study.resolve() if options.study else folder / "study.toml"
    if not options.study:
        study.write_text(STUDY.format(source=source, last=100 + 10 * (options.proofs // 2 - 1)))
    (folder / "hosts.txt").write_text("".join(f"2/{name}\n" for name in HOSTS))
    by_parallel = ["--engine", "parallel", "--hosts", str(folder / "hosts.txt")]
    cluster = Cluster(folder)
    try:
        cluster.start()
        pal = str(pathlib.Path(options.pal).resolve())
        tables = {}
        block = [] if options.study else ["--block", "10"]
        for name, arguments in [("one-core", ["--jobs", "1"]), ("two-cores", ["--jobs", "2"]), ("parallel", [*by_parallel, *block]),
                                ("slurm", ["--engine", "slurm", *block])]:
            tables[name] = sweep(cluster, pal, study, name, arguments)
        third = options.proofs // 3
        for name, arguments, host in [] if options.study else [("parallel-without-pal2", by_parallel, 1), ("slurm-without-pal3", ["--engine", "slurm"], 2)]:
            tables[name] = sweep(cluster, pal, study, name, [*arguments, *block], (cluster.hosts[host], third))
    finally:
        cluster.stop()
    different = [name for name, files in tables.items() if files != tables["one-core"]]
    print(f"the files of {', '.join(different)} differ" if different else f"{len(tables)} studies wrote the same {len(tables['one-core'])} files")
    return 1 if different else 0


if __name__ == "__main__":
    sys.exit(main())
