// Undo and redo over values that are never changed in place.

export class History<T> {
  private readonly before: T[] = [];
  private after: T[] = [];
  private saved: T;
  onChange: (value: T) => void = () => undefined;

  constructor(private now: T) { this.saved = now; }

  get value(): T { return this.now; }
  get canUndo(): boolean { return this.before.length > 0; }
  get canRedo(): boolean { return this.after.length > 0; }
  get changed(): boolean { return this.now !== this.saved; }

  /** `merge`: one step with the change before it, as the many small moves of one slider are. */
  set(value: T, merge = false): void {
    if (!merge || this.before.length === 0) this.before.push(this.now);
    this.after = [];
    this.show(value);
  }

  undo(): void {
    const value = this.before.pop();
    if (value === undefined) return;
    this.after.push(this.now);
    this.show(value);
  }

  redo(): void {
    const value = this.after.pop();
    if (value === undefined) return;
    this.before.push(this.now);
    this.show(value);
  }

  markSaved(): void {
    this.saved = this.now;
    this.onChange(this.now);
  }

  private show(value: T): void {
    this.now = value;
    this.onChange(value);
  }
}
