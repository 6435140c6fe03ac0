// The connection to the server: commands and questions with their answers, and messages of numbers. It comes back by
// itself when it was lost.

const kTypes = {f32: Float32Array, i32: Int32Array, u16: Uint16Array, u8: Uint8Array};

// A message of numbers: head with its arrays by name.
export function decode(buffer) {
  const size = new DataView(buffer).getUint32(0, true);
  const head = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 4, size)));
  let at = 4 + size;
  for (const [name, type, count] of head.arrays) {
    const array = new kTypes[type](buffer, at, count);
    head[name] = array;
    at += Math.ceil(array.byteLength / 4) * 4;
  }
  return head;
}

export class Connection {
  // `heard` gets each message that is no answer, `changed` the state: "open", "lost", "refused", "full".
  constructor(heard, changed) {
    this.heard = heard;
    this.changed = changed;
    this.waiting = new Map();
    this.next_id = 1;
    this.patience = 500;
    this.connect();
  }

  connect() {
    this.pictures = 0;
    const scheme = location.protocol === "https:" ? "wss://" : "ws://";
    this.socket = new WebSocket(scheme + location.host + "/live", "quicksand");
    this.socket.binaryType = "arraybuffer";
    this.opened = false;
    this.socket.onopen = () => {
      this.opened = true;
      this.patience = 500;
      this.changed("open");
    };
    this.socket.onmessage = (event) => this.take(event.data);
    this.socket.onclose = () => this.lost();
  }

  async lost() {
    for (const {reject} of this.waiting.values()) reject(new Error("the connection was lost"));
    this.waiting.clear();
    const status = await fetch("shaders.json").then((r) => r.status, () => 0);
    if (status === 401) return this.changed("refused");
    this.changed(status === 200 && !this.opened ? "full" : "lost");
    setTimeout(() => this.connect(), this.patience);
    this.patience = Math.min(4000, 1.5 * this.patience);
  }

  take(data) {
    if (data instanceof ArrayBuffer) {
      const message = decode(data);
      if (message.kind === "frame") ++this.pictures;
      return this.heard(message);
    }
    const message = JSON.parse(data);
    const asked = this.waiting.get(message.id);
    this.waiting.delete(message.id);
    if (!asked) return this.heard(message);
    if (message.ok) return asked.resolve(message.result);
    const error = new Error((message.where ? message.where + ": " : "") + message.error);
    asked.reject(error);
  }

  send(message) {
    if (this.socket.readyState !== WebSocket.OPEN) return Promise.reject(new Error("not connected"));
    const id = this.next_id++;
    this.socket.send(JSON.stringify({...message, id}));
    return new Promise((resolve, reject) => this.waiting.set(id, {resolve, reject}));
  }

  command(name, values = {}) { return this.send({command: name, ...values}); }
  ask(name, values = {}) { return this.send({ask: name, ...values}); }

  // Tells that all pictures so far were drawn: then the next one comes.
  drawn() {
    if (this.socket.readyState === WebSocket.OPEN) this.socket.send(new Uint32Array([this.pictures]));
  }
}
